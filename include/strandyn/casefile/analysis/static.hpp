#pragma once
/// \file `type = "static"`: a path of equilibrium.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

struct StaticAnalysis {
  static constexpr std::string_view word = "static";
  static constexpr bool needs_span = true;
  int steps = 20;
  std::vector<double> slip_map_loads;  ///< [N] where the slipping wires at the first static force's point are listed
};

template <class V>
void keys(V& v, StaticAnalysis& a) {
  v.number(
      "steps", a.steps,
      {.help = "the number of equal steps to the full load or displacement, or the most arc steps", .at_least = 1});
  v.numbers("slip_map_loads_N", a.slip_map_loads,
            {.help = "loads, at which the slipping wires of the section at the loaded point are listed",
             .unit = units::N,
             .at_least = 0});
}

}  // namespace strandyn::casefile
