#include "strandyn/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "strandyn/report/cycle_table.hpp"
#include "strandyn/report/format.hpp"
#include "strandyn/report/svg_plot.hpp"

namespace strandyn::report {
namespace {

using nlohmann::ordered_json;

/// A scalar, or a list of them, as it stands in the file.
std::string as_written(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (value.is_array()) {
    std::vector<std::string> parts;
    for (const auto& item : value) parts.push_back(as_written(item));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  return value.dump();
}

/// A value of a result, divided by the factor of its prefix; counts keep all their digits.
std::string rounded(const ordered_json& value, double factor) {
  if (value.is_null()) return "–";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer() && factor == 1) return value.dump();
  if (value.is_number()) return typeset(value.get<double>() / factor);
  return as_written(value);
}

/// The prefix that suits the largest number of a column.
Prefix prefix_of_column(const ordered_json& objects, const std::string& key, const std::string& unit) {
  double largest = 0;
  for (const auto& object : objects) {
    const auto found = object.find(key);
    if (found != object.end() && found->is_number()) largest = std::max(largest, std::abs(found->get<double>()));
  }
  return takes_prefix(unit) ? prefix_for(largest) : Prefix{1, ""};
}

/// An entry that html_list leaves to a table of its own.
bool is_table(const ordered_json& value) {
  return is_list_of_objects(value);
}

void add_entries(const ordered_json& object, const std::string& path, Wording wording, std::string& out) {
  for (const auto& [key, value] : object.items()) {
    if (is_table(value)) continue;
    if (value.is_object()) {
      add_entries(value, path + key + ".", wording, out);
      continue;
    }
    Label label{path + key, ""};
    std::string shown = as_written(value);
    if (wording == Wording::result) {
      const Label plain = label_of(key);
      Quantity of_value{rounded(value, 1), plain.unit};
      if (value.is_number_float()) of_value = quantity(value.get<double>(), plain.unit);
      label = {path + plain.name, of_value.unit};
      shown = of_value.number;
    }
    out += fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>\n", escaped(label.name), escaped(shown),
                       label.unit.empty() ? "" : " <span class=\"unit\">" + escaped(label.unit) + "</span>");
  }
}

}  // namespace

bool is_list_of_objects(const ordered_json& json) {
  return json.is_array() && !json.empty() &&
         std::all_of(json.begin(), json.end(), [](const auto& item) { return item.is_object(); });
}

std::string html(const HtmlTable& table) {
  constexpr std::size_t few_columns = 3;  // spread over the whole page, they could not be read across
  std::string out = fmt::format("<div class=\"scroll\"><table{}>\n<thead><tr>",
                                table.columns.size() <= few_columns ? " class=\"narrow\"" : "");
  const auto kind = [&](std::size_t i) { return table.columns[i].words ? " class=\"words\"" : ""; };
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    out += fmt::format("<th{}>{}{}</th>", kind(i), escaped(column.header),
                       column.unit.empty() ? "" : "<span class=\"unit\">" + escaped(column.unit) + "</span>");
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("<td{}>{}</td>", kind(i), escaped(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

HtmlTable table_of_objects(const ordered_json& objects, Wording wording, std::size_t most_rows) {
  HtmlTable table;
  std::vector<std::string> keys;
  std::vector<double> factors;
  for (const auto& object : objects) {
    for (const auto& [key, value] : object.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }
  for (const std::string& key : keys) {
    const bool words = std::any_of(objects.begin(), objects.end(), [&](const auto& object) {
      const auto found = object.find(key);
      return found != object.end() && !found->is_number() && !found->is_null();
    });
    if (wording == Wording::as_written) {
      factors.push_back(1);
      table.columns.push_back({.header = key, .words = words});
      continue;
    }
    const Label label = label_of(key);
    const Prefix prefix = prefix_of_column(objects, key, label.unit);
    factors.push_back(prefix.factor);
    table.columns.push_back({.header = label.name, .unit = std::string(prefix.symbol) + label.unit, .words = words});
  }
  for (const std::size_t i : evenly_spaced(objects.size(), most_rows)) {
    auto& row = table.rows.emplace_back();
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const auto found = objects[i].find(keys[k]);
      if (found == objects[i].end()) {
        row.emplace_back("–");
      } else {
        row.push_back(wording == Wording::as_written ? as_written(*found) : rounded(*found, factors[k]));
      }
    }
  }
  return table;
}

std::string html_list(const ordered_json& object, Wording wording) {
  std::string entries;
  add_entries(object, "", wording, entries);
  return entries.empty() ? "" : "<dl>\n" + entries + "</dl>\n";
}

}  // namespace strandyn::report
