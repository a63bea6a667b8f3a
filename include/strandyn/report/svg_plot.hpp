#pragma once
/// \file Plots as SVG: no scripts, no fonts, nothing from outside.
///
/// A plot that stands alone brings colours that can be read on white and on black paper, since whoever shows it (a
/// README) does not say which it has. A plot inside the page leaves the colours of text and grid to the page.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/report/ticks.hpp"

namespace strandyn::report {

enum class Colour { ink, blue, orange, green, red, violet, teal, grey };

struct Series {
  std::string name = {};   ///< in the legend; left out of it where empty
  std::string label = {};  ///< of a line that is not in the legend, for whoever asks
  std::vector<double> x;
  std::vector<double> y;
  Colour colour = Colour::blue;
  std::string custom_colour = {};  ///< "#rrggbb" instead of `colour`
  bool line = true;
  bool dashed = false;
  bool markers = false;
  bool filled = false;           ///< down to zero, lightly
  double width = 1.75;           ///< [px]
  std::vector<double> low = {};  ///< the lower edge of a band whose upper edge is y; a line where empty
};

/// Values over x and y, as colours.
struct Cells {
  std::string label = {};  ///< of the value
  std::string unit = {};
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> value;
};

/// Wires of a cross-section, each with a value as its colour. Lengths in one unit; the drawing keeps their proportions.
struct Wires {
  std::string label = {};  ///< of the value, from 0 to 1
  std::vector<double> x, y, radius;
  std::vector<double> value;
};

struct Axis {
  std::string label = {};
  std::string unit = {};  ///< gets a prefix of its own where it takes one (J -> mJ)
  bool log = false;       ///< points that are not positive are left out
  bool from_zero = false;
  bool tight = false;  ///< the axis ends where the data end, not at the next tick
};

struct Plot {
  std::string title;
  Axis x = {};
  Axis y = {};
  std::vector<Series> series = {};
  std::optional<Cells> cells = {};
  std::optional<Wires> wires = {};  ///< alone: without axes
  std::string note = {};            ///< what it leaves out, beside the caption
  int width = 720;                  ///< [px]
  int height = 400;                 ///< [px]
};

enum class SvgUse { standalone, inside_page };

/// Points that are not finite are left out. A plot without a point shows its empty axes.
std::string svg(const Plot& plot, SvgUse use = SvgUse::standalone);

/// `count` colours along a ramp from blue over violet to orange, for series that have an order.
std::vector<std::string> ramp(std::size_t count);

/// & < > and quotes made harmless for HTML and SVG.
std::string escaped(std::string_view text);

}  // namespace strandyn::report
