#include "strandyn/report/interactive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/results/json.hpp"
#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

using results::Value;

constexpr std::size_t most_points = 5000;  // of a line: more than a screen has

Value list_of(const std::vector<double>& values) {
  Value list = Value::list();
  for (const double value : values) list.append(std::isfinite(value) ? Value(value) : Value());
  return list;
}

Value axis_of(const Axis& axis, const std::vector<std::vector<Point>>& all, double Point::*coordinate) {
  const Scale scale(axis, data_range(all, axis, coordinate), 5);
  return Value::object(
      {{"title", scale.title}, {"factor", scale.factor()}, {"log", axis.log}, {"from_zero", axis.from_zero}});
}

Value line_of(const Series& series) {
  Value line = Value::object({{"name", series.name},
                              {"label", series.label.empty() ? series.name : series.label},
                              {"x", list_of(series.x)},
                              {"y", list_of(series.y)},
                              {"colour", colour_of(series)},
                              {"width", series.width},
                              {"line", series.line},
                              {"dashed", series.dashed},
                              {"markers", series.markers},
                              {"filled", series.filled}});
  if (!series.low.empty()) line.set("low", list_of(series.low));
  return line;
}

Value cells_of(const Cells& cells) {
  Value colours = Value::list();
  for (const std::string& colour : ramp(9)) colours.append(Value(colour));
  return Value::object({{"title", cells.unit.empty() ? cells.label : fmt::format("{} ({})", cells.label, cells.unit)},
                        {"x", list_of(cells.x)},
                        {"y", list_of(cells.y)},
                        {"value", list_of(cells.value)},
                        {"ramp", colours}});
}

Value numbers_of(const PagePlot& shown) {
  const Plot& plot = *shown.plot;
  std::vector<std::vector<Point>> all;
  for (const Series& series : plot.series) {
    all.push_back(shown_points(series.x, series.y, plot));
    all.push_back(shown_points(series.x, series.low, plot));
  }
  if (plot.cells) all.push_back(shown_points(plot.cells->x, plot.cells->y, plot));
  Value numbers = Value::object({{"name", shown.name},
                                 {"moves", shown.moves},
                                 {"x", axis_of(plot.x, all, &Point::x)},
                                 {"y", axis_of(plot.y, all, &Point::y)}});
  Value lines = Value::list();
  for (const Series& series : plot.series) lines.append(line_of(thinned(series, most_points)));
  numbers.set("lines", lines);
  if (plot.cells) numbers.set("cells", cells_of(*plot.cells));
  return numbers;
}

/// Nothing in it may look like the end of its element.
std::string inside_script(std::string_view text) {
  std::string harmless;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '/' && i > 0 && text[i - 1] == '<') harmless += '\\';
    harmless += text[i];
  }
  return harmless;
}

}  // namespace

Series thinned(const Series& series, std::size_t points) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  if (count <= points) return series;
  Series few = series;
  few.x.clear(), few.y.clear(), few.low.clear();
  const auto keep = [&](std::size_t i) {
    few.x.push_back(series.x[i]);
    few.y.push_back(series.y[i]);
    if (!series.low.empty()) few.low.push_back(series.low[i]);
  };
  const std::size_t parts = points / 2 - 1;
  keep(0);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t from = 1 + part * (count - 2) / parts, to = 1 + (part + 1) * (count - 2) / parts;
    if (from == to) continue;
    const auto begin = series.y.begin();
    const auto [low, high] =
        std::minmax_element(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to));
    const auto first = static_cast<std::size_t>(std::min(low, high) - begin);
    const auto second = static_cast<std::size_t>(std::max(low, high) - begin);
    keep(first);
    if (second != first) keep(second);
  }
  keep(count - 1);
  return few;
}

std::string interactive(const std::vector<PagePlot>& plots) {
  const PageScripts scripts = page_scripts();
  if (scripts.library.empty() || plots.empty()) return {};
  Value all = Value::list();
  for (const PagePlot& plot : plots) all.append(numbers_of(plot));
  return fmt::format(
      "<script type=\"application/json\" id=\"plots\">{}</script>\n<script>{}</script>\n<script>{}</script>\n",
      inside_script(results::to_text(all, -1)), scripts.library, scripts.plots);
}

}  // namespace strandyn::report
