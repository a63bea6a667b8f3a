#pragma once
/// \file What an SVG drawing is made of: texts, lines and colours; its axes; the cells of a map.

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/report/format.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/report/ticks.hpp"

namespace strandyn::report {

struct Point {
  double x = 0;
  double y = 0;
};

/// Width of a text in the wider ones of the common sans-serif faces: what is laid out with it never overlaps.
double text_width(std::string_view text, double size);

/// A coordinate with two decimals at most.
std::string px(double value);

/// "#rrggbb"; empty for the ink, which is the page's.
std::string_view colour_of(const Series& series);
/// Attributes that paint a line or a shape in the colour of the series.
std::string painted(const Series& series, std::string_view attribute);

std::string text_at(Point at, std::string_view style, std::string_view anchor, std::string_view text);
std::string line_between(Point a, Point b, std::string_view style);

/// Path data through the points; those that fall on the same spot of the screen are drawn once.
std::string path_data(const std::vector<Point>& pixels);

/// One axis: from values to pixels, and its ticks.
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
  /// By which values of the data are divided before they are shown: that of the unit's prefix.
  double factor() const { return prefix_.factor; }
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
/// Those points that the axes can show.
std::vector<Point> shown_points(const std::vector<double>& x, const std::vector<double>& y, const Plot& plot);

/// What the axis has to hold; never empty, never of no width.
Range data_range(const std::vector<std::vector<Point>>& all, const Axis& axis, double Point::*coordinate);

/// Cells that fill the frame; the values stand on a grid, with holes or without.
std::string drawn(const Cells& cells, const Plot& plot, const Scale& x, const Scale& y, Point top_left,
                  Point bottom_right);

/// What stands in the place of axes and lines: circles as large as the frame lets them be.
std::string drawn(const Wires& wires, Point top_left, Point bottom_right);

/// Name, unit and ends of the colours, on one line that ends at `end`.
std::string colour_key(const Cells& cells, Point end);

}  // namespace strandyn::report
