#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "svg_parts.hpp"

namespace strandyn::report {

std::string drawn(const Wires& wires, Point top_left, Point bottom_right) {
  constexpr std::size_t levels = 32;
  double reach = std::numeric_limits<double>::min();  // from the middle, to either side
  for (std::size_t i = 0; i < wires.x.size(); ++i) {
    reach = std::max(reach, std::max(std::abs(wires.x[i]), std::abs(wires.y[i])) + wires.radius[i]);
  }
  const double width = bottom_right.x - top_left.x, height = bottom_right.y - top_left.y;
  const double per_unit = std::min(width, height) / (2 * reach);
  const Point middle{(top_left.x + bottom_right.x) / 2, (top_left.y + bottom_right.y) / 2};
  const auto colours = ramp(levels);
  std::string out = "<g stroke-width=\"1\">\n";
  for (std::size_t i = 0; i < wires.x.size(); ++i) {
    const auto level = static_cast<std::size_t>(std::clamp(wires.value[i], 0.0, 1.0) * (levels - 1));
    const std::string fill = wires.value[i] > 0 ? colours[level] : "none";
    out += fmt::format("<circle class=\"axis\" fill=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", fill,
                       px(middle.x + per_unit * wires.x[i]), px(middle.y - per_unit * wires.y[i]),
                       px(per_unit * wires.radius[i]));
  }
  return out + "</g>\n";
}

}  // namespace strandyn::report
