#include "strandyn/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <map>
#include <type_traits>
#include <utility>

#include "strandyn/report/format.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/results/label.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::report {
namespace {

using results::is_share;
using results::Label;
using results::label_of;
using results::Value;

bool is_whole(const Value& value) {
  return value.visit([](const auto& data) {
    using T = std::remove_cvref_t<decltype(data)>;
    return std::integral<T> && !std::same_as<T, bool>;
  });
}

/// A scalar, or a list of them, as it stands in the file; a long list by its beginning, deeper ones by their size.
std::string as_in_file(const Value& value) {
  constexpr std::size_t most_entries = 12;
  if (value.is_null()) return "null";
  if (const auto* words = value.words()) return *words;
  if (const auto flag = value.flag()) return *flag ? "true" : "false";
  if (const auto number = value.number()) return fmt::format("{}", *number);
  if (is_list_of_objects(value)) return fmt::format("{} entries", value.entries().size());
  const auto& entries = value.entries();
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < std::min(entries.size(), most_entries); ++i) parts.push_back(as_in_file(entries[i]));
  if (entries.size() > most_entries) parts.push_back(fmt::format("… ({} in all)", entries.size()));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

/// A value of a result, divided by the factor of its prefix; counts keep all their digits.
std::string rounded(const Value& value, double factor = 1, int digits = 4) {
  constexpr std::size_t few = 6;
  if (value.is_null()) return "–";
  if (const auto flag = value.flag()) return *flag ? "yes" : "no";
  const auto number = value.number();
  if (number && !(is_whole(value) && factor == 1)) return typeset(*number / factor, digits);
  if (value.entries().empty() || value.entries().size() > few || is_list_of_objects(value)) return as_in_file(value);
  std::vector<std::string> parts;
  for (const Value& entry : value.entries()) parts.push_back(rounded(entry, factor));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// All entries that are no objects, with their paths.
using Flat = std::vector<std::pair<std::string, const Value*>>;

void flatten(const Value& object, const std::string& path, Flat& out) {
  for (const auto& [key, value] : object.members()) {
    if (value.is_object()) {
      flatten(value, path + key + ".", out);
    } else {
      out.emplace_back(path + key, &value);
    }
  }
}

Flat flat(const Value& object) {
  Flat out;
  flatten(object, "", out);
  return out;
}

const Value* find(const Flat& entries, const std::string& path) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == path; });
  return found == entries.end() ? nullptr : found->second;
}

std::string unit_span(const std::string& unit, std::string_view before) {
  return unit.empty() ? "" : fmt::format("{}<span class=\"unit\">{}</span>", before, escaped(unit));
}

std::string entry_of(const std::string& path, const Value& value, const Wording& wording) {
  std::string name = path;
  Quantity shown{as_in_file(value), ""};
  if (!wording.as_in_file) {
    const Label label = label_of(path);
    name = label.name;
    shown = {rounded(value), label.unit};
    if (const auto number = value.number(); number && is_share(path)) {
      shown = {typeset(100 * *number, 3), "%"};
    } else if (number && !is_whole(value)) {
      shown = quantity(*number, label.unit);
    }
  }
  return fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>\n", escaped(name), escaped(shown.number),
                     unit_span(shown.unit, " "));
}

}  // namespace

bool is_list_of_objects(const Value& value) {
  const auto& entries = value.entries();
  return !entries.empty() &&
         std::all_of(entries.begin(), entries.end(), [](const Value& entry) { return entry.is_object(); });
}

std::string html(const HtmlTable& table) {
  constexpr std::size_t few_columns = 3;  // spread over the whole page, they could not be read across
  std::string out = fmt::format("<div class=\"scroll\"><table{}>\n<thead><tr>",
                                table.columns.size() <= few_columns ? " class=\"narrow\"" : "");
  const auto kind = [&](std::size_t i) { return table.columns[i].words ? " class=\"words\"" : ""; };
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    out += fmt::format("<th{}>{}{}</th>", kind(i), escaped(column.header), unit_span(column.unit, ""));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("<td{}>{}</td>", kind(i), escaped(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

HtmlTable table_of_objects(const Value& objects, const Wording& wording, std::size_t most_rows) {
  std::vector<Flat> rows;
  std::vector<std::string> paths;
  for (const Value& object : objects.entries()) {
    rows.push_back(flat(object));
    for (const auto& [path, value] : rows.back()) {
      if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
    }
  }
  HtmlTable table;
  std::vector<Prefix> prefixes;
  const std::vector<Label> labels = results::labels_of(paths);
  std::map<std::string, double> largest;  // by path, and of all energies of a unit
  const auto rank = [&](std::size_t k) {
    const bool energy = labels[k].unit.starts_with("J") || labels[k].unit.starts_with("W");
    return energy ? labels[k].unit : paths[k];
  };
  for (const Flat& row : rows) {
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const Value* value = find(row, paths[k]);
      if (value) largest[rank(k)] = std::max(largest[rank(k)], std::abs(value->number().value_or(0)));
    }
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const bool words = std::any_of(rows.begin(), rows.end(), [&](const Flat& row) {
      const Value* value = find(row, paths[k]);
      return value && !value->number() && !value->is_null();
    });
    const std::string unit = wording.as_in_file ? "" : labels[k].unit;
    const bool share = !wording.as_in_file && is_share(paths[k]);
    prefixes.push_back(share ? Prefix{0.01, ""} : takes_prefix(unit) ? prefix_for(largest[rank(k)]) : Prefix{});
    table.columns.push_back({.header = wording.as_in_file ? paths[k] : labels[k].name,
                             .unit = share ? std::string("%") : std::string(prefixes[k].symbol) + unit,
                             .words = words});
  }
  for (const std::size_t i : results::evenly_spaced(rows.size(), most_rows)) {
    auto& cells = table.rows.emplace_back();
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const Value* value = find(rows[i], paths[k]);
      const int digits = is_share(paths[k]) ? 3 : 4;
      if (!value) {
        cells.emplace_back("–");
      } else if (wording.as_in_file) {
        cells.push_back(as_in_file(*value));
      } else if (wording.for_terminal && value->number() && !is_whole(*value)) {
        cells.push_back(significant(*value->number() / prefixes[k].factor, digits));
      } else {
        cells.push_back(rounded(*value, prefixes[k].factor, digits));
      }
    }
  }
  return table;
}

std::string html_of_object(const Value& object, const Wording& wording) {
  constexpr std::size_t most_rows = 50;
  std::string list;
  std::string tables;
  for (const auto& [path, value] : flat(object)) {
    const auto* skip = wording.left_out;
    if (skip && std::find(skip->begin(), skip->end(), wording.path + path) != skip->end()) continue;
    if (is_list_of_objects(*value)) {
      const std::string name = wording.as_in_file ? "[[" + wording.path + path + "]]" : label_of(path).name;
      tables += "<h4>" + escaped(name) + "</h4>\n" + html(table_of_objects(*value, wording, most_rows));
    } else if (!value->is_list() || !value->entries().empty() || wording.as_in_file) {
      list += entry_of(path, *value, wording);
    }
  }
  return (list.empty() ? "" : "<dl>\n" + list + "</dl>\n") + tables;
}

std::string html_of_list(std::string_view name, const Value& list, std::size_t most_rows) {
  Value rows = Value::list();
  for (const Value& entry : list.entries()) {
    Value row = Value::object();
    row.set("number", rows.entries().size() + 1);
    row.set(name, entry);
    rows.append(std::move(row));
  }
  return html(table_of_objects(rows, {}, most_rows));
}

}  // namespace strandyn::report
