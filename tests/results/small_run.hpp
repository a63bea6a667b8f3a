#pragma once
/// \file A small results folder, written by records as a run writes it.

#include <filesystem>
#include <string>
#include <vector>

#include "strandyn/results/figure.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::test {

struct SmallRun {
  std::vector<results::Highlight> highlights = {};
  std::vector<results::Figure> figures = {};
  std::vector<results::ShownTable> shown = {};
  std::vector<results::NamedTable> tables = {};
  results::Value more = results::Value::object();  ///< replaces or adds members of the summary

  results::Value summary() const {
    using results::Value;
    Value summary = Value::object();
    summary.set("title", "Curlew <30 m> & shaker");
    summary.set("status", "done");
    summary.set("program", Value::object({{"version", "0.1.0"}, {"compiler", "GNU 12.2.0"}}));
    summary.set("case", Value::object({{"title", "x"},
                                       {"conductor", Value::object({{"catalogue", "curlew"}})},
                                       {"span", Value::object({{"length_m", 30}, {"tension_kN", 24.42}})},
                                       {"load", Value::list({Value::object({{"type", "harmonic-force"},
                                                                            {"at_m", 0.7},
                                                                            {"direction", Value::list({0, 1, 0})}})})},
                                       {"section", Value::object({{"law", "return-map"}})},
                                       {"analysis", Value::object({{"type", "forced"}})}}));
    summary.set("section", Value::object({{"EA_N", 4.71459e7}, {"EI_max_N_m2", 2387.42}}));
    summary.set("cost", Value::object({{"wall_s", 12.5}, {"steps", 40000}}));
    summary.set("warnings", Value::list({Value("drive is off <resonance>")}));
    summary.set("highlights", results::to_value(highlights));
    summary.set("figures", results::to_value(figures));
    summary.set("shown_tables", results::to_value(shown));
    summary.merge(more);
    return summary;
  }

  void write(const std::filesystem::path& folder) const {
    for (const results::NamedTable& named : tables) results::write_csv(folder / named.file, named.table);
    results::write_json(folder / "summary.json", summary());
  }
};

/// Rows of numbers under names.
inline results::Table table_of_rows(std::vector<std::string> names, const std::vector<std::vector<double>>& rows) {
  results::Table table(std::move(names));
  for (const auto& row : rows) table.append(row);
  return table;
}

}  // namespace strandyn::test
