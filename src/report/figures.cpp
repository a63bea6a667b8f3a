#include "strandyn/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "line_names.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/label.hpp"
#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

using results::Figure;
using results::Label;
using results::Table;

InputError refusal(const Figure& figure, std::string_view fault) {
  return InputError(fmt::format("the figure '{}' of summary.json {}", figure.name, fault));
}

void check(const Figure& figure, const Table& table) {
  constexpr std::array<std::string_view, 7> kinds = {"line", "points", "band", "map", "section", "motion", "wires"};
  if (std::find(kinds.begin(), kinds.end(), figure.kind) == kinds.end()) {
    throw refusal(figure, fmt::format("is of the kind '{}'; there are {}", figure.kind, fmt::join(kinds, ", ")));
  }
  for (const std::string& scale : {figure.x_scale, figure.y_scale}) {
    if (scale != "linear" && scale != "log") {
      throw refusal(figure, fmt::format("has the scale '{}'; there are linear and log", scale));
    }
  }
  if (figure.kind == "band" && figure.y.size() != 2) {
    throw refusal(figure, fmt::format("is a band of {} columns; it takes the low and the high one", figure.y.size()));
  }
  if (figure.kind == "wires" && figure.y.size() != 3) {
    throw refusal(figure,
                  fmt::format("shows wires by {} columns; it takes the height, the radius and the share that is "
                              "coloured",
                              figure.y.size()));
  }
  std::vector<std::string> asked = {figure.x};
  asked.insert(asked.end(), figure.y.begin(), figure.y.end());
  asked.insert(asked.end(), figure.series.begin(), figure.series.end());
  for (const std::string& name : asked) {
    if (table.has(name)) continue;
    throw refusal(figure, fmt::format("asks for the column '{}' of {}, which has {}", name, figure.table,
                                      fmt::join(table.names(), ", ")));
  }
}

std::vector<std::size_t> rows_inside(const Figure& figure, const Table& table) {
  std::vector<std::size_t> rows;
  const auto& x = table.column(figure.x);
  for (std::size_t row = 0; row < x.size(); ++row) {
    const bool inside = !figure.x_range || (x[row] >= (*figure.x_range)[0] && x[row] <= (*figure.x_range)[1]);
    if (inside) rows.push_back(row);
  }
  return rows;
}

std::vector<double> values_of(const Table& table, const std::string& column, const std::vector<std::size_t>& rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(table.column(column)[row]);
  return values;
}

/// What an axis shows whose columns have no words in common.
std::string_view word_for(std::string_view unit) {
  if (unit == "J") return "energy";
  if (unit == "J/m") return "energy per length";
  if (unit == "W") return "power";
  if (unit == "W/m") return "power per length";
  if (unit == "N") return "force";
  return unit == "N m" ? "moment" : "";
}

/// The words with which all names end, a blank before them; empty where a name would not be left with any.
std::string common_end(const std::vector<Label>& labels) {
  std::string end = labels.front().name;
  for (const Label& label : labels) {
    while (!end.empty() && !(label.name.ends_with(end) && label.name.size() > end.size())) {
      const auto blank = end.find(' ', 1);
      end = blank == std::string::npos ? "" : end.substr(blank);
    }
  }
  return end.starts_with(' ') ? end : "";
}

/// The y axis, and the names of the lines without what stands at the axis.
struct YNames {
  Label axis;
  std::vector<std::string> of_lines;
};

YNames y_names(const std::vector<std::string>& columns) {
  if (columns.size() == 1) return {.axis = results::label_of(columns[0]), .of_lines = {""}};
  YNames names;
  std::vector<Label> labels;
  for (const std::string& column : columns) labels.push_back(results::label_of(column));
  const bool one_unit =
      std::all_of(labels.begin(), labels.end(), [&](const Label& label) { return label.unit == labels[0].unit; });
  if (one_unit) names.axis.unit = labels[0].unit;
  const std::string end = one_unit ? common_end(labels) : "";
  names.axis.name = end.empty() ? word_for(names.axis.unit) : end.substr(1);
  const std::vector<Label> shorter = results::labels_of(columns);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string& name = labels[i].name;
    const std::string unit = one_unit || labels[i].unit.empty() ? "" : " (" + labels[i].unit + ")";
    names.of_lines.push_back(end.empty() ? shorter[i].name + unit : name.substr(0, name.size() - end.size()));
  }
  return names;
}

bool says(const std::string& column, std::string_view word) {
  return column.find(word) != std::string::npos;
}

/// Columns that are zero throughout tell nothing beside others, but for those that a reader wants to see at zero.
std::vector<std::string> drawn_columns(const Figure& figure, const Table& table, const std::vector<std::size_t>& rows) {
  std::vector<std::string> columns = figure.y;
  if (columns.size() == 1) return columns;
  std::erase_if(columns, [&](const std::string& name) {
    if (says(name, "friction") || says(name, "numerical")) return false;
    return std::ranges::all_of(values_of(table, name, rows), [](double value) { return value == 0; });
  });
  return columns;
}

/// Columns that only numbers set apart: modes, layers, probes.
bool are_numbered(const std::vector<std::string>& columns) {
  const auto without_digits = [](std::string name) {
    std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });
    return name;
  };
  return std::all_of(columns.begin(), columns.end(),
                     [&](const std::string& name) { return without_digits(name) == without_digits(columns.front()); });
}

/// Colours by the words in a name: what friction takes is orange, what the integrator does is red and dashed, what
/// comes from outside is of the colour of the text; the others follow a palette.
void paint(std::vector<Series>& lines, const std::vector<std::string>& columns) {
  struct Meaning {
    std::string_view word;
    Colour colour;
  };
  constexpr std::array<Meaning, 4> meanings = {
      {{"numerical", Colour::red}, {"friction", Colour::orange}, {"external", Colour::ink}, {"viscous", Colour::blue}}};
  std::vector<Colour> palette = {Colour::teal, Colour::grey, Colour::violet, Colour::green, Colour::blue};
  const std::size_t most = palette.size() + meanings.size();
  const bool ordered = columns.size() > 1 && (are_numbered(columns) || columns.size() > most);
  const auto colours = ramp(columns.size());
  if (std::ranges::any_of(columns, [](const std::string& name) { return says(name, "viscous"); })) palette.pop_back();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto meaning = std::ranges::find_if(meanings, [&](const Meaning& m) { return says(columns[i], m.word); });
    if (ordered) {
      lines[i].custom_colour = colours[i];
    } else if (meaning != meanings.end()) {
      lines[i].colour = meaning->colour;
      lines[i].dashed = meaning->colour == Colour::red;
      lines[i].markers = lines[i].markers && !lines[i].dashed;
    } else {
      lines[i].colour = palette.back();
      if (palette.size() > 1) palette.pop_back();
    }
  }
}

std::size_t points_shown(const Plot& plot) {
  std::size_t most = plot.cells ? plot.cells->x.size() : 0;
  for (const Series& line : plot.series) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i) count += is_shown(line.x[i], plot.x) && is_shown(line.y[i], plot.y);
    most = std::max(most, count);
  }
  return most;
}

/// Along x an axis of lines that go on and on ends with them. Up it begins at zero where that hides nothing.
void settle_axes(Plot& plot) {
  constexpr double near = 0.5;  // of the largest value: above, zero would press the lines together
  std::vector<double> all;
  plot.x.tight = !plot.x.log;
  for (const Series& line : plot.series) {
    plot.x.tight = plot.x.tight && std::ranges::is_sorted(line.x);
    all.insert(all.end(), line.y.begin(), line.y.end());
    all.insert(all.end(), line.low.begin(), line.low.end());
  }
  if (all.empty()) return;
  const auto [low, high] = std::ranges::minmax(all);
  plot.y.from_zero = low >= 0 && low <= near * high;
}

void add_lines(const Figure& figure, const Table& table, const std::vector<std::size_t>& rows, Plot& plot) {
  constexpr std::size_t few_points = 40;  // markers where single points can be told apart
  constexpr std::size_t most_names = 8;
  constexpr std::size_t most_groups = 24;  // more cannot be told apart
  const bool band = figure.kind == "band";
  std::vector<std::string> columns = band ? figure.y : drawn_columns(figure, table, rows);
  if (columns.empty()) return;
  const YNames names = y_names(columns);
  plot.y.label = names.axis.name;
  plot.y.unit = names.axis.unit;
  if (band) columns = {figure.y[1]};
  const results::Groups groups = results::groups_of(table, figure.series, rows);
  const auto group_names = names_of(groups, figure.series);
  const auto colours = ramp(groups.size());
  // The moments of a motion are shown one at a time.
  const auto drawn = results::evenly_spaced(groups.size(), figure.kind == "motion" ? groups.size() : most_groups);
  std::vector<std::size_t> named;
  for (const std::size_t i : results::evenly_spaced(drawn.size(), most_names)) named.push_back(drawn[i]);
  if (drawn.size() < groups.size()) {
    plot.note = fmt::format("{} of {} lines are drawn; all are in {}.", drawn.size(), groups.size(), figure.table);
  }
  std::size_t group = 0;
  for (const auto& [key, own_rows] : groups) {
    if (std::find(drawn.begin(), drawn.end(), group) == drawn.end()) {
      ++group;
      continue;
    }
    std::vector<Series> lines;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      Series line{.x = values_of(table, figure.x, own_rows), .y = values_of(table, columns[i], own_rows)};
      if (band) line.low = values_of(table, figure.y[0], own_rows);
      line.line = figure.kind != "points";
      line.markers = !line.line || (!band && line.x.size() <= few_points);
      const std::string own = band ? "" : names.of_lines[i];
      const bool both = !own.empty() && !group_names[group].empty();
      line.label = own + (both ? ", " : "") + group_names[group];
      if (std::find(named.begin(), named.end(), group) != named.end()) {
        line.name = line.label;
        // A fit is the dashed line beside its points, in every group.
        const bool fit = columns.size() == 2 && says(columns[1], "fitted") && groups.size() > 1;
        if (fit) line.name = i == 0 ? group_names[group] : "";
      }
      lines.push_back(std::move(line));
    }
    paint(lines, columns);
    for (std::size_t i = 0; i < lines.size() && groups.size() > 1; ++i) {
      lines[i].custom_colour = colours[group];
      lines[i].dashed = i > 0;
    }
    std::move(lines.begin(), lines.end(), std::back_inserter(plot.series));
    ++group;
  }
  settle_axes(plot);
  // The area below a line that stands alone, and below what friction takes.
  const bool with_areas = figure.kind == "line" && !plot.y.log && plot.x.tight;
  for (Series& line : plot.series) {
    const bool friction = line.colour == Colour::orange && line.custom_colour.empty();
    line.filled = with_areas && (plot.series.size() == 1 ? plot.y.from_zero : friction);
  }
}

}  // namespace

std::optional<Plot> plot_of(const Figure& figure, const Table& table) {
  check(figure, table);
  const Label along_x = results::label_of(figure.x);
  Plot plot{.title = figure.title,
            .x = {.label = along_x.name, .unit = along_x.unit, .log = figure.x_scale == "log"},
            .y = {.log = figure.y_scale == "log"}};
  const std::vector<std::size_t> rows = rows_inside(figure, table);
  if (figure.kind == "wires") {
    plot.wires = Wires{.label = results::label_of(figure.y[2]).name,
                       .x = values_of(table, figure.x, rows),
                       .y = values_of(table, figure.y[0], rows),
                       .radius = values_of(table, figure.y[1], rows),
                       .value = values_of(table, figure.y[2], rows)};
    return rows.empty() ? std::nullopt : std::optional(std::move(plot));
  }
  if (figure.kind == "map" && figure.y.size() == 2 && figure.series.empty()) {
    const Label along_y = results::label_of(figure.y[0]);
    const Label value = results::label_of(figure.y[1]);
    plot.y.label = along_y.name;
    plot.y.unit = along_y.unit;
    plot.x.tight = plot.y.tight = true;
    plot.cells = Cells{.label = value.name,
                       .unit = value.unit,
                       .x = values_of(table, figure.x, rows),
                       .y = values_of(table, figure.y[0], rows),
                       .value = values_of(table, figure.y[1], rows)};
  } else {
    add_lines(figure, table, rows, plot);
  }
  if (points_shown(plot) == 0) return std::nullopt;
  return plot;
}

}  // namespace strandyn::report
