#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/results/table.hpp"
#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

constexpr std::size_t levels = 32;
constexpr std::size_t most_cells = 150;  // along an axis: as many as can be told apart

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
    std::vector<double> kept;
    for (const std::size_t i : results::evenly_spaced(at.size(), most_cells)) kept.push_back(at[i]);
    at = kept;
    edges = {from};
    for (std::size_t i = 1; i < at.size(); ++i) edges.push_back((scale(at[i - 1]) + scale(at[i])) / 2);
    edges.push_back(to);
  }
  /// The edges around a value; null where it is none of those that are drawn.
  const double* find(double value) const {
    const auto found = std::lower_bound(at.begin(), at.end(), value);
    return found != at.end() && *found == value ? &edges[static_cast<std::size_t>(found - at.begin())] : nullptr;
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
    const double* across = columns.find(cells.x[i]);
    const double* up = rows.find(cells.y[i]);
    if (!across || !up) continue;
    const double share = range.width() > 0 ? (cells.value[i] - range.low) / range.width() : 0;
    const auto level = std::min(static_cast<std::size_t>(share * levels), levels - 1);
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
