#include "strandyn/report/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/core/error.hpp"
#include "strandyn/report/text_table.hpp"
#include "strandyn/results/label.hpp"

namespace strandyn::report {
namespace {

using results::Value;

bool are_counts(const std::vector<double>& values) {
  constexpr double most = 1e9;  // beyond, digits say less than a power of ten
  return std::all_of(values.begin(), values.end(), [](double x) { return x == std::round(x) && std::abs(x) < most; });
}

/// The rows that are printed; whole numbers without a unit are counts.
Value rows_of(const results::ShownTable& shown, const results::Table& table, std::size_t most_rows) {
  Value rows = Value::list();
  for (const std::size_t row : results::evenly_spaced(table.rows(), most_rows)) {
    Value entry = Value::object();
    for (const std::string& name : shown.columns) {
      const auto& column = table.column(name);
      const bool count = results::label_of(name).unit.empty() && are_counts(column);
      entry.set(name, count ? Value(std::llround(column[row])) : Value(column[row]));
    }
    rows.append(std::move(entry));
  }
  return rows;
}

/// Broken at the blank that leaves the shorter lines.
std::string in_two_lines(std::string header) {
  constexpr int short_enough = 10;
  std::size_t best = std::string::npos;
  std::size_t length = header.size();
  for (auto blank = header.find(' '); blank != std::string::npos; blank = header.find(' ', blank + 1)) {
    const std::size_t longer = std::max(blank, header.size() - blank - 1);
    if (longer < length) best = blank, length = longer;
  }
  if (best != std::string::npos && shown_width(header) > short_enough) header[best] = '\n';
  return header;
}

/// For terminals that have only plain letters.
std::string plain(std::string unit) {
  constexpr std::string_view micro = "µ";
  if (unit.starts_with(micro)) unit.replace(0, micro.size(), "u");
  return unit;
}

}  // namespace

Quantity quantity_of(const results::Highlight& highlight) {
  std::string_view key = highlight.path;
  key = key.substr(0, key.find('[', key.rfind('.') + 1));
  const std::string unit = results::label_of(key).unit;
  if (results::is_share(key)) return {typeset(100 * highlight.value, 3), "%"};
  if (unit.empty() && are_counts({highlight.value})) return {fmt::format("{}", highlight.value), ""};
  return quantity(highlight.value, unit);
}

std::string text_of(const std::vector<results::Highlight>& highlights) {
  int name_width = 0;
  int number_width = 0;
  for (const results::Highlight& highlight : highlights) {
    name_width = std::max(name_width, shown_width(highlight.name));
    number_width = std::max(number_width, shown_width(quantity_of(highlight).number));
  }
  std::string text;
  for (const results::Highlight& highlight : highlights) {
    const Quantity shown = quantity_of(highlight);
    std::string line =
        fmt::format("{:<{}}  {:>{}} {}", highlight.name, name_width, shown.number, number_width, plain(shown.unit));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

HtmlTable html_of(const results::ShownTable& shown, const results::Table& table, const Showing& how) {
  for (const std::string& name : shown.columns) {
    if (table.has(name)) continue;
    throw InputError(fmt::format("the shown table '{}' of summary.json asks for the column '{}' of {}, which has {}",
                                 shown.title, name, shown.table, fmt::join(table.names(), ", ")));
  }
  return table_of_objects(rows_of(shown, table, how.most_rows), {.for_terminal = how.for_terminal}, how.most_rows);
}

std::string text_of(const results::ShownTable& shown, const results::Table& table) {
  const HtmlTable printed = html_of(shown, table, {.for_terminal = true});
  if (printed.rows.empty()) return {};
  std::vector<TextColumn> heads;
  for (const auto& column : printed.columns) {
    heads.push_back({.header = in_two_lines(column.header), .unit = plain(column.unit)});
  }
  TextTable text(std::move(heads));
  for (const auto& row : printed.rows) text.add_row({row.begin(), row.end()});
  if (printed.rows.size() == table.rows()) return text.str();
  return text.str() + fmt::format("({} of {} rows; all are in {})\n", printed.rows.size(), table.rows(), shown.table);
}

}  // namespace strandyn::report
