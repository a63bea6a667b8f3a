#pragma once
/// \file Where the ticks of an axis stand and how they are labelled.

#include <string>
#include <vector>

namespace strandyn::report {

struct Range {
  double low = 0;
  double high = 1;
  double width() const { return high - low; }
};

struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;  ///< one per tick; empty for an unlabelled tick of a log axis
};

/// 1, 2 or 5 times a power of ten: the smallest such step that covers the range in at most `most` steps.
double nice_step(Range range, int most);

/// The range widened to multiples of `nice_step`.
Range widened_to_steps(Range range, int most);

/// Multiples of `nice_step` inside the range; all labels of one axis have the same number of decimals.
Ticks linear_ticks(Range range, int most);

/// Decades inside the range, with 2 and 5 in between where there are less than three of them, and only every
/// n-th where there are many. The range is positive.
Ticks log_ticks(Range range);

}  // namespace strandyn::report
