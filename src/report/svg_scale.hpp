#pragma once
/// \file One axis of a drawing: from values to pixels, and its ticks.

#include <string>
#include <vector>

#include "strandyn/report/format.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/report/ticks.hpp"
#include "svg_pieces.hpp"

namespace strandyn::report {

class Scale {
 public:
  Scale(const Axis& axis, Range data, int most_ticks);

  void place(double from_px, double to_px) { from_ = from_px, to_ = to_px; }

  /// Pixel of a value in the unit of the data.
  double operator()(double value) const { return of_shown(value / prefix_.factor); }
  /// Pixel of a value in the unit of the ticks.
  double of_shown(double value) const;
  /// Pixel of zero, or of the end nearest to it.
  double base() const;
  bool zero_inside() const { return !log_ && range_.low < 0 && range_.high > 0; }

  std::string title;
  Ticks ticks;

 private:
  bool log_;
  Prefix prefix_{1, ""};
  Range range_;
  double from_ = 0;
  double to_ = 1;
};

bool is_shown(double value, const Axis& axis);

/// What the axis has to hold; never empty, never of no width.
Range data_range(const std::vector<std::vector<Point>>& all, const Axis& axis, double Point::*coordinate);

}  // namespace strandyn::report
