#pragma once
/// \file Cycles of an irregular history by rainflow counting.                                [ASTM E1049-85, 5.4.4]
///
/// Of a row of peaks and valleys X is the range under consideration, Y the one before it. While X >= Y: where Y holds
/// the first point of the history it is half a cycle, and that point goes; else Y is a whole cycle, and its two points
/// go. What is left at the end are half cycles. Points that are neither peak nor valley do not count.

#include <span>
#include <vector>

namespace strandyn::fatigue {

struct CountedCycle {
  double range = 0;  ///< peak less valley, >= 0, in the unit of the history
  double mean = 0;   ///< of both
  double count = 1;  ///< 1 or 0.5

  double amplitude() const { return range / 2; }
};

/// In the order in which they close. Empty where nothing changes.
std::vector<CountedCycle> rainflow(std::span<const double> history);

}  // namespace strandyn::fatigue
