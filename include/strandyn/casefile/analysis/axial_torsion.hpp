#pragma once
/// \file `type = "axial-torsion"`: tension and torsion of a strand, by several theories.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

struct AxialTorsionAnalysis {
  static constexpr std::string_view word = "axial-torsion";
  static constexpr bool needs_conductor = true;
  double axial_strain = 0.001;  ///< [-]
};

template <class V>
void keys(V& v, AxialTorsionAnalysis& a) {
  v.number("axial_strain", a.axial_strain, {.help = "the axial strain", .above = -1, .below = 1});
}

}  // namespace strandyn::casefile
