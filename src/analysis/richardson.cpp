#include "strandyn/analysis/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::analysis {

double richardson(double difference, std::optional<double> before, const Order& order) {
  constexpr double sure = 1.5, unsure = 3, unknown = 2.5;
  const auto growth = [&](double q) { return std::pow(order.ratio, q); };
  if (!before || !std::isfinite(*before) || !(std::max(difference, *before) > 0))
    return unknown * difference / (growth(order.expected) - 1);
  /// What the difference would be, if the order were q.
  const auto foreseen = [&](double q) { return *before * (1 - 1 / growth(q)) / (std::pow(order.ratio_before, q) - 1); };
  // Two runs may agree by chance: on both sides of a resonance, for one.
  difference = std::max(difference, foreseen(order.highest));
  const double safety = difference <= foreseen(order.expected - 0.5) ? sure : unsure;
  double seen = order.least, above = order.highest;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (seen + above);
    (foreseen(middle) >= difference ? seen : above) = middle;
  }
  return safety * difference / (growth(seen) - 1);
}

}  // namespace strandyn::analysis
