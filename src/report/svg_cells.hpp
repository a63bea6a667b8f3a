#pragma once
/// \file Values over a plane: cells in colours, and the key to them.

#include "svg_scale.hpp"

namespace strandyn::report {

/// Cells that fill the frame; the values stand on a grid, with holes or without.
std::string drawn(const Cells& cells, const Plot& plot, const Scale& x, const Scale& y, Point top_left,
                  Point bottom_right);

/// Name, unit and ends of the colours, on one line that ends at `end`.
std::string colour_key(const Cells& cells, Point end);

}  // namespace strandyn::report
