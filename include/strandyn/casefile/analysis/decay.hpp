#pragma once
/// \file `type = "decay"`: the free decay of a mode.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

struct DecayAnalysis {
  static constexpr std::string_view word = "decay";
  static constexpr bool needs_span = true;
  static constexpr bool needs_mass = true;
  int highest_mode() const { return mode; }
  int mode = 1;
  std::optional<double> antinode_amplitude;  ///< [m] empty: [initial] starts the motion
  int cycles = 0;
};

template <class V>
void keys(V& v, DecayAnalysis& a) {
  v.number("mode", a.mode, {.help = "the mode that decays", .at_least = 1, .required = true});
  v.number(
      "antinode_amplitude_mm", a.antinode_amplitude,
      {.help =
           "the amplitude at the start, of the largest antinode away from the ends; next to a clamp a loop swings up "
           "to 1 % wider",
       .unit = units::mm,
       .above = 0});
  v.number("cycles", a.cycles, {.help = "the number of cycles", .at_least = 1, .required = true});
}

}  // namespace strandyn::casefile
