#pragma once
/// \file Texts, lines and colours of an SVG drawing.

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/report/svg_plot.hpp"

namespace strandyn::report {

struct Point {
  double x = 0;
  double y = 0;
};

/// Width of a text in the wider ones of the common sans-serif faces: what is laid out with it never overlaps.
double text_width(std::string_view text, double size);

/// A coordinate with two decimals at most.
std::string px(double value);

/// Attributes that paint a line or a shape in the colour of the series.
std::string painted(const Series& series, std::string_view attribute);

std::string text_at(Point at, std::string_view style, std::string_view anchor, std::string_view text);
std::string line_between(Point a, Point b, std::string_view style);

/// Path data through the points; those that fall on the same spot of the screen are drawn once.
std::string path_data(const std::vector<Point>& pixels);

}  // namespace strandyn::report
