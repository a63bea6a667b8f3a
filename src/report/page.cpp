#include "strandyn/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strandyn/core/error.hpp"
#include "strandyn/report/cycle_table.hpp"
#include "strandyn/report/figures.hpp"
#include "strandyn/report/format.hpp"
#include "strandyn/report/html.hpp"
#include "strandyn/report/page_style.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::report {
namespace {

using nlohmann::ordered_json;

/// What the folder holds. `cycles` comes from the summary or, where it has none, from cycles.csv.
struct Contents {
  ordered_json summary;
  ordered_json cycles = ordered_json::array();
  std::optional<results::Table> profile;
  std::optional<results::Table> loops;
  std::optional<results::Table> modes;
};

/// The value at a path of keys, or null.
const ordered_json& at(const ordered_json& json, const std::vector<const char*>& path) {
  static const ordered_json nothing;
  const ordered_json* here = &json;
  for (const char* key : path) {
    if (!here->is_object()) return nothing;
    const auto found = here->find(key);
    if (found == here->end()) return nothing;
    here = &*found;
  }
  return *here;
}

std::string words_at(const ordered_json& json, const std::vector<const char*>& path, std::string otherwise = {}) {
  const ordered_json& value = at(json, path);
  return value.is_string() ? value.get<std::string>() : otherwise;
}

ordered_json read_summary(const std::filesystem::path& folder) {
  const auto path = folder / "summary.json";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw FileError(fmt::format("there is no {}: give the folder that `strandyn run` wrote", path.string()));
  }
  const auto broken = [&](std::string_view fault) {
    return InputError(fmt::format("{}: {}; run the case again to write it anew", path.string(), fault));
  };
  try {
    auto summary = ordered_json::parse(results::read_file(path));
    if (!summary.is_object()) throw broken("not a summary: expected a JSON object at the top");
    return summary;
  } catch (const ordered_json::parse_error& error) {
    const std::string_view text = error.what();
    const auto place = text.find("parse error");
    throw broken(place == std::string_view::npos ? text : text.substr(place));
  }
}

std::optional<results::Table> read_if_there(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  return results::read_csv(path);
}

Contents read_folder(const std::filesystem::path& folder) {
  Contents contents;
  contents.summary = read_summary(folder);
  contents.profile = read_if_there(folder / "dissipation_profile.csv");
  contents.loops = read_if_there(folder / "loop.csv");
  contents.modes = read_if_there(folder / "modes.csv");
  if (is_list_of_objects(at(contents.summary, {"cycles"}))) {
    contents.cycles = contents.summary["cycles"];
  } else if (const auto table = read_if_there(folder / "cycles.csv")) {
    for (std::size_t row = 0; row < table->rows(); ++row) {
      ordered_json cycle;
      for (const std::string& name : table->names()) cycle[name] = table->column(name)[row];
      contents.cycles.push_back(std::move(cycle));
    }
  }
  return contents;
}

std::vector<Figure> figures_of(const Contents& contents) {
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  const auto cycles = cycle_rows(contents.cycles);
  add(energy_figure(cycles));
  add(amplitude_figure(cycles));
  if (contents.loops) add(loops_figure(*contents.loops));
  if (contents.profile) {
    add(dissipation_figure(*contents.profile));
    add(dissipation_near_support_figure(*contents.profile));
    add(curvature_figure(*contents.profile));
  }
  if (contents.modes) add(modes_figure(*contents.modes));
  if (const auto& points = at(contents.summary, {"points"}); is_list_of_objects(points))
    add(self_damping_figure(points));
  if (const auto& steps = at(contents.summary, {"steps"}); is_list_of_objects(steps)) add(static_figure(steps));
  return figures;
}

std::string section(std::string_view heading, std::string_view body) {
  if (body.empty()) return {};
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(heading), body);
}

/// "forced vibration, curlew, 30 m, 24.4 kN, return-map": what the reader wants to know of the case first.
std::string facts(const ordered_json& summary) {
  std::vector<std::string> parts;
  const auto add = [&](const std::vector<const char*>& path, std::string_view before, std::string_view after) {
    const ordered_json& value = at(summary, path);
    if (value.is_string()) parts.push_back(fmt::format("{}{}{}", before, value.get<std::string>(), after));
    if (value.is_number()) parts.push_back(fmt::format("{}{}{}", before, value.get<double>(), after));
  };
  add({"case", "conductor", "catalogue"}, "conductor ", "");
  add({"case", "span", "length_m"}, "", " m span");
  add({"case", "span", "tension_kN"}, "", " kN");
  add({"case", "span", "tension_rts"}, "", " of the rated strength");
  add({"case", "section", "law"}, "section law ", "");
  std::string out;
  for (const std::string& part : parts) out += fmt::format("<li>{}</li>", escaped(part));
  return out.empty() ? "" : "<ul class=\"facts\">" + out + "</ul>\n";
}

std::string header(const ordered_json& summary) {
  const std::string status = words_at(summary, {"status"});
  const std::string type = words_at(summary, {"case", "analysis", "type"});
  return fmt::format("<header>\n<p class=\"eyebrow\">strandyn{}{}</p>\n<h1>{}</h1>\n{}</header>\n",
                     type.empty() ? "" : " · " + escaped(type),
                     status.empty() ? ""
                                    : fmt::format(" <span class=\"status{}\">{}</span>",
                                                  status == "done" ? " good" : "", escaped(status)),
                     escaped(words_at(summary, {"title"}, "Results")), facts(summary));
}

/// The numbers that the run was made for, each where the summary has it.
std::string key_numbers(const ordered_json& summary) {
  struct Key {
    std::vector<const char*> path;
    const char* name;
  };
  static const std::array<Key, 14> keys = {{{{"steady", "antinode_amplitude_m"}, "antinode amplitude"},
                                            {{"steady", "friction_dissipation_J"}, "friction per cycle"},
                                            {{"steady", "numerical_share"}, "numerical share"},
                                            {{"steady", "self_damping_W_per_m"}, "self-damping"},
                                            {{"steady", "damping_ratio"}, "damping ratio"},
                                            {{"steady", "loss_factor"}, "loss factor"},
                                            {{"chi_0_per_m"}, "curvature of full slip χ₀"},
                                            {{"M_0_N_m"}, "moment of full slip M₀"},
                                            {{"fit", "k"}, "fit: factor k"},
                                            {{"fit", "l"}, "fit: amplitude exponent"},
                                            {{"fit", "m"}, "fit: frequency exponent"},
                                            {{"fit", "n"}, "fit: tension exponent"},
                                            {{"fit", "r2"}, "fit: R²"},
                                            {{"energy_balance", "antinode_amplitude_m"}, "balance amplitude"}}};
  std::string cards;
  for (const Key& key : keys) {
    const ordered_json& value = at(summary, key.path);
    if (!value.is_number()) continue;
    const std::string_view last = key.path.back();
    const Quantity shown = last == "numerical_share" ? Quantity{typeset(100 * value.get<double>(), 3), "%"}
                                                     : quantity(value.get<double>(), label_of(last).unit);
    cards += fmt::format("<div><dt>{}</dt><dd>{} <span class=\"unit\">{}</span></dd></div>\n", key.name, shown.number,
                         shown.unit);
  }
  return cards.empty() ? "" : section("Key numbers", "<dl class=\"cards\">\n" + cards + "</dl>\n");
}

std::string warnings(const ordered_json& summary) {
  std::string items;
  if (const auto& list = at(summary, {"warnings"}); list.is_array()) {
    for (const auto& warning : list) {
      items += fmt::format("<li>{}</li>\n", escaped(warning.is_string() ? warning.get<std::string>() : warning.dump()));
    }
  }
  if (items.empty()) return {};
  return "<section class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n" + items + "</ul>\n</section>\n";
}

std::string plots(const std::vector<Figure>& figures) {
  std::string body;
  for (const Figure& figure : figures) {
    // Two stand side by side on the page: drawn smaller, so that their text keeps its size.
    Plot plot = figure.plot;
    plot.width = 500;
    plot.height = 310;
    body += fmt::format("<figure>\n<h3>{}</h3>\n{}<figcaption>{}</figcaption>\n</figure>\n", escaped(figure.plot.title),
                        svg(plot, SvgUse::inside_page), escaped(figure.caption));
  }
  return body.empty() ? "" : section("Plots", "<div class=\"figures\">\n" + body + "</div>\n");
}

std::string cycles_section(const ordered_json& cycles) {
  const auto rows = cycle_rows(cycles);
  if (rows.empty()) return {};
  // The same numbers as in the terminal.
  const Prefix prefix = energy_prefix(rows);
  const std::string energy = std::string(prefix.symbol) + "J";
  HtmlTable table{.columns = {{.header = "cycle"},
                              {.header = "time", .unit = "s"},
                              {.header = "amplitude", .unit = "mm"},
                              {.header = "external work", .unit = energy},
                              {.header = "stored", .unit = energy},
                              {.header = "viscous", .unit = energy},
                              {.header = "friction", .unit = energy},
                              {.header = "numerical", .unit = energy},
                              {.header = "numerical share", .unit = "%"},
                              {.header = "slipping", .unit = "elements"}},
                  .rows = {}};
  const auto shown = [](std::optional<double> value, double factor, int digits = 4) {
    return value ? typeset(*value / factor, digits) : "–";
  };
  constexpr std::size_t most_rows = 20;
  for (const std::size_t i : evenly_spaced(rows.size(), most_rows)) {
    const CycleRow& row = rows[i];
    table.rows.push_back({std::to_string(row.cycle), shown(row.t, 1), shown(row.antinode_amplitude, 1e-3),
                          shown(row.external, prefix.factor), shown(row.stored, prefix.factor),
                          shown(row.viscous, prefix.factor), shown(row.friction, prefix.factor),
                          shown(row.numerical, prefix.factor), shown(row.numerical_share, 1e-2, 3),
                          shown(row.elements_slipping, 1, 1)});
  }
  const std::string note =
      rows.size() > most_rows ? fmt::format("<p class=\"note\">{} of {} cycles.</p>\n", most_rows, rows.size()) : "";
  return section("Energy of each cycle", html(table) + note);
}

/// Whatever else the summary holds: lists of objects as tables, objects as lists, numbers in a row.
std::string other_results(const ordered_json& summary) {
  static constexpr std::array<std::string_view, 9> shown_elsewhere = {
      "title", "status", "program", "case", "section", "cost", "warnings", "cycles", "steady"};
  constexpr std::size_t most_rows = 100;
  std::string out;
  ordered_json loose;
  for (const auto& [key, value] : summary.items()) {
    if (std::find(shown_elsewhere.begin(), shown_elsewhere.end(), key) != shown_elsewhere.end()) continue;
    if (is_list_of_objects(value)) {
      out += section(label_of(key).name, html(table_of_objects(value, Wording::result, most_rows)));
    } else if (value.is_object()) {
      out += section(label_of(key).name, html_list(value, Wording::result));
    } else if (value.is_array() && !value.empty()) {
      auto rows = ordered_json::array();
      for (const auto& item : value) rows.push_back({{"number", rows.size() + 1}, {key, item}});
      out += section(label_of(key).name, html(table_of_objects(rows, Wording::result, most_rows)));
    } else if (!value.is_array()) {
      loose[key] = value;
    }
  }
  return section("Results", html_list(loose, Wording::result)) + out;
}

/// The case, one card per table of the case file.
std::string the_case(const ordered_json& summary) {
  const ordered_json& as_run = at(summary, {"case"});
  if (!as_run.is_object()) return {};
  std::string cards;
  ordered_json general;
  const auto add_card = [&](const std::string& name, const std::string& body) {
    if (!body.empty()) cards += fmt::format("<div class=\"card\">\n<h3>{}</h3>\n{}</div>\n", escaped(name), body);
  };
  constexpr std::size_t most_rows = 50;
  for (const auto& [key, value] : as_run.items()) {
    if (is_list_of_objects(value)) {
      add_card("[[" + key + "]]", html(table_of_objects(value, Wording::as_written, most_rows)));
    } else if (value.is_object()) {
      std::string body = html_list(value, Wording::as_written);
      for (const auto& [inner, list] : value.items()) {
        if (!is_list_of_objects(list)) continue;
        body += fmt::format("<h4>[[{}.{}]]</h4>\n", escaped(key), escaped(inner)) +
                html(table_of_objects(list, Wording::as_written, most_rows));
      }
      add_card("[" + key + "]", body);
    } else if (key != "title") {
      general[key] = value;
    }
  }
  const std::string loose = general.empty() ? "" : html_list(general, Wording::as_written);
  return section("The case as run", loose + "<div class=\"cards-of-case\">\n" + cards + "</div>\n");
}

std::string list_section(const ordered_json& summary, const char* key, std::string_view heading) {
  const ordered_json& object = at(summary, {key});
  return object.is_object() ? section(heading, html_list(object, Wording::result)) : "";
}

std::string page(const Contents& contents, const std::vector<Figure>& figures) {
  const ordered_json& summary = contents.summary;
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<meta name=\"color-scheme\" content=\"light dark\">\n"
             "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n",
             escaped(words_at(summary, {"title"}, "Results")), page_style()) +
         header(summary) + key_numbers(summary) + warnings(summary) + plots(figures) + cycles_section(contents.cycles) +
         list_section(summary, "steady", "Mean of the last cycles") + other_results(summary) +
         list_section(summary, "section", "The cross section") + the_case(summary) +
         list_section(summary, "cost", "What it cost") + list_section(summary, "program", "The program") +
         "</main>\n</body>\n</html>\n";
}

}  // namespace

std::filesystem::path write_report(const std::filesystem::path& folder) {
  const Contents contents = read_folder(folder);
  const std::vector<Figure> figures = figures_of(contents);
  for (const Figure& figure : figures) results::write_file(folder / (figure.name + ".svg"), svg(figure.plot));
  const auto path = folder / "report.html";
  results::write_file(path, page(contents, figures));
  return path;
}

}  // namespace strandyn::report
