#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

/// The next 1, 2 or 5 times a power of ten at or below the value.
double widened_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
  for (const double factor : {5.0, 2.0}) {
    if (value >= factor * power * (1 - 1e-9)) return factor * power;
  }
  return power;
}

}  // namespace

Scale::Scale(const Axis& axis, Range data, int most_ticks) : log_(axis.log) {
  const double largest = std::max(std::abs(data.low), std::abs(data.high));
  if (takes_prefix(axis.unit)) prefix_ = prefix_for(largest);
  const std::string unit = axis.unit.empty() ? "" : fmt::format("{}{}", prefix_.symbol, axis.unit);
  title = axis.label.empty() ? unit : axis.label + (unit.empty() ? "" : " (" + unit + ")");
  range_ = {data.low / prefix_.factor, data.high / prefix_.factor};
  if (log_) {
    if (!axis.tight) range_ = {widened_down(range_.low), 1 / widened_down(1 / range_.high)};
    ticks = log_ticks(range_);
    if (std::count(ticks.labels.begin(), ticks.labels.end(), "") + 1 >= std::ssize(ticks.labels)) {
      ticks = linear_ticks(range_, most_ticks);
    }
  } else {
    if (!axis.tight) range_ = widened_to_steps(range_, most_ticks);
    ticks = linear_ticks(range_, most_ticks);
  }
}

double Scale::of_shown(double value) const {
  const double share = log_ ? (std::log(value) - std::log(range_.low)) / (std::log(range_.high) - std::log(range_.low))
                            : (value - range_.low) / range_.width();
  return from_ + share * (to_ - from_);
}

double Scale::base() const {
  return log_ ? from_ : of_shown(std::clamp(0.0, range_.low, range_.high));
}

bool is_shown(double value, const Axis& axis) {
  return std::isfinite(value) && (!axis.log || value > 0);
}

std::vector<Point> shown_points(const std::vector<double>& x, const std::vector<double>& y, const Plot& plot) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (is_shown(x[i], plot.x) && is_shown(y[i], plot.y)) points.push_back({x[i], y[i]});
  }
  return points;
}

Range data_range(const std::vector<std::vector<Point>>& all, const Axis& axis, double Point::*coordinate) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& points : all) {
    for (const Point& point : points) {
      range.low = std::min(range.low, point.*coordinate);
      range.high = std::max(range.high, point.*coordinate);
    }
  }
  if (range.low > range.high) range = axis.log ? Range{1, 10} : Range{0, 1};
  if (axis.from_zero && !axis.log) range = {std::min(range.low, 0.0), std::max(range.high, 0.0)};
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (range.width() <= 1e-9 * largest || largest == 0) {
    if (axis.log) return {range.low / 2, range.high * 2};
    const double half = largest == 0 ? 1 : 0.1 * largest;
    return {range.low - half, range.high + half};
  }
  return range;
}

}  // namespace strandyn::report
