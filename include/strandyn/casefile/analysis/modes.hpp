#pragma once
/// \file `type = "modes"`: natural frequencies and shapes.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

struct ModesAnalysis {
  static constexpr std::string_view word = "modes";
  static constexpr bool needs_span = true;
  static constexpr bool needs_mass = true;
  int highest_mode() const { return count; }
  /// A frequency is the whole answer here: a loop of lumped masses is (pi/24)^2/24 too low, 0.07 %.
  static constexpr double elements_per_loop = 24;
  int count = 12;
  std::optional<double> near_frequency;  ///< [Hz] the modes nearest to it; empty: the lowest
};

template <class V>
void keys(V& v, ModesAnalysis& a) {
  v.number("count", a.count, {.help = "the number of modes", .at_least = 1});
  v.number("near_Hz", a.near_frequency,
           {.help = "the frequency whose nearest modes are wanted (the lowest unless given)",
            .unit = units::Hz,
            .above = 0});
}

}  // namespace strandyn::casefile
