#include "strandyn/analysis/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::analysis {

double richardson(double difference, std::optional<double> before, const Order& order) {
  constexpr double sure = 1.5, unsure = 3, unknown = 2.5;
  const auto growth = [&](double q) { return std::pow(order.ratio, q); };
  if (!before || !std::isfinite(*before) || !(std::max(difference, *before) > 0))
    return unknown * difference / (growth(order.expected) - 1);
  const double seen = std::log2(*before / difference) / std::log2(order.ratio);
  // Two runs may agree by chance: on both sides of a resonance, for one.
  difference = std::max(difference, *before / growth(order.highest));
  const double safety = seen >= order.expected - 0.5 ? sure : unsure;
  return safety * difference / (growth(std::clamp(seen, order.least, order.highest)) - 1);
}

}  // namespace strandyn::analysis
