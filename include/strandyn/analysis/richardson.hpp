#pragma once
/// \file What the finer of two runs is off by, from how far they are apart.  [Richardson 1911]
///
///     e = s |D(h) - D(r h)|/(r^q - 1)
/// with the order q that a third run, coarser again by a ratio t, shows:
///     |D(h) - D(r h)|/|D(r h) - D(t r h)| = (1 - r^-q)/(t^q - 1),   r^-q where t = r
/// held between bounds. s is what covered the error in nineteen of twenty random scenes
/// (`docs/accuracy-presets.md`): 1.5 where the order is the one expected, 3 where it is less, 2.5 where there is no
/// third run.

#include <optional>

namespace strandyn::analysis {

/// [-] orders of convergence, and how much coarser each run is than the one before: the second than the first, the
/// third than the second.
struct Order {
  double least = 0, highest = 0, expected = 0;
  double ratio = 2, ratio_before = ratio;
};

/// The error of the finer of two runs that are `difference` apart, the next two being `before` apart. In the unit of
/// the difference; infinite where that is.
double richardson(double difference, std::optional<double> before, const Order& order);

}  // namespace strandyn::analysis
