#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

constexpr std::size_t levels = 32;

Range value_range(const Cells& cells) {
  const auto [low, high] = std::minmax_element(cells.value.begin(), cells.value.end());
  return cells.value.empty() ? Range{} : Range{*low, *high};
}

/// The values of one axis in ascending order, and the pixels halfway between them.
struct Grid {
  Grid(std::vector<double> values, const Axis& axis, const Scale& scale, double from, double to)
      : at(std::move(values)) {
    std::erase_if(at, [&](double value) { return !is_shown(value, axis); });
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    edges = {from};
    for (std::size_t i = 1; i < at.size(); ++i) edges.push_back((scale(at[i - 1]) + scale(at[i])) / 2);
    edges.push_back(to);
  }
  std::size_t find(double value) const {
    return static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), value) - at.begin());
  }

  std::vector<double> at;
  std::vector<double> edges;
};

}  // namespace

std::string drawn(const Cells& cells, const Plot& plot, const Scale& x, const Scale& y, Point top_left,
                  Point bottom_right) {
  const Grid columns(cells.x, plot.x, x, top_left.x, bottom_right.x);
  const Grid rows(cells.y, plot.y, y, bottom_right.y, top_left.y);
  const Range range = value_range(cells);
  std::vector<std::string> of_level(levels);
  for (std::size_t i = 0; i < cells.value.size(); ++i) {
    if (!is_shown(cells.x[i], plot.x) || !is_shown(cells.y[i], plot.y)) continue;
    const double share = range.width() > 0 ? (cells.value[i] - range.low) / range.width() : 0;
    const auto level = std::min(static_cast<std::size_t>(share * levels), levels - 1);
    const double* across = &columns.edges[columns.find(cells.x[i])];
    const double* up = &rows.edges[rows.find(cells.y[i])];
    of_level[level] +=
        fmt::format("M{} {}H{}V{}H{}Z", px(across[0]), px(up[0]), px(across[1]), px(up[1]), px(across[0]));
  }
  const auto colours = ramp(levels);
  std::string out = "<g shape-rendering=\"crispEdges\">\n";
  for (std::size_t k = 0; k < levels; ++k) {
    if (!of_level[k].empty()) out += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colours[k], of_level[k]);
  }
  return out + "</g>\n";
}

std::string colour_key(const Cells& cells, Point end) {
  constexpr double size = 12.5;
  constexpr double step = 3;
  constexpr double gap = 7;
  const Range range = value_range(cells);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const Prefix prefix = takes_prefix(cells.unit) ? prefix_for(largest) : Prefix{1, ""};
  const std::string unit = cells.unit.empty() ? "" : fmt::format(" ({}{})", prefix.symbol, cells.unit);
  const std::string high = typeset(range.high / prefix.factor, 3);
  double at = end.x - text_width(high, size) - gap - step * levels;
  std::string out = text_at(end, "label", "end", high) +
                    text_at({at - gap, end.y}, "label", "end",
                            fmt::format("{}{}: {}", cells.label, unit, typeset(range.low / prefix.factor, 3)));
  for (const std::string& colour : ramp(levels)) {
    out += fmt::format("<path fill=\"{}\" shape-rendering=\"crispEdges\" d=\"M{} {}h{}v9h-{}Z\"/>\n", colour, px(at),
                       px(end.y - 9), step, step);
    at += step;
  }
  return out;
}

}  // namespace strandyn::report
