#pragma once
/// \file `type = "section"`: symmetric cycles of a section, a path from a file, the wires of a bent strand.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class Twist { held, free };
constexpr auto words_of(Twist) {
  return std::array{Named{Twist::held, "held"}, Named{Twist::free, "free"}};
}

struct SectionAnalysis {
  static constexpr std::string_view word = "section";
  std::vector<double> tensions;              ///< [N]
  std::vector<double> tensions_rts;          ///< [-]; see `section_tensions`
  std::vector<double> curvature_amplitudes;  ///< [1/m] this, or
  std::vector<double> relative_amplitudes;   ///< [-] of chi_0, or path
  std::vector<double> frictions;             ///< [-] of all contacts; empty: the conductor's own
  bool compare_residual_forces = false;      ///< each loop once more without residual forces
  std::vector<double> wires_at;              ///< [1/m] where wire forces are listed
  int steps_per_cycle = 400;
  Twist twist = Twist::held;
  std::optional<std::string> path;  ///< csv file of strain, torsion, curvatures, as written in the case
};

template <class V>
void keys(V& v, SectionAnalysis& a) {
  v.one_of({"tension_kN", "tension_rts"}, {});
  v.numbers("tension_kN", a.tensions, {.help = "the tension, or a list of them", .unit = units::kN, .at_least = 0});
  v.numbers("tension_rts", a.tensions_rts,
            {.help = "the tension as a part of the rated strength, or a list of them", .at_least = 0, .at_most = 1});
  v.one_of({"curvature_amplitudes_per_m", "curvature_over_chi_0", "path"}, {.required = true});
  v.numbers("curvature_amplitudes_per_m", a.curvature_amplitudes,
            {.help = "the amplitudes of symmetric cycles of curvature", .unit = units::per_m, .above = 0});
  v.numbers("curvature_over_chi_0", a.relative_amplitudes,
            {.help = "the same as multiples of the yield curvature chi_0 of each tension and friction", .above = 0});
  v.numbers("frictions", a.frictions,
            {.help = "friction coefficients of all contacts, each with loops of its own (else the conductor's)",
             .at_least = 0});
  v.flag("compare_residual_forces", a.compare_residual_forces,
         {.help = "whether to run the same without residual forces beside it"});
  v.numbers("wires_at_per_m", a.wires_at,
            {.help = "curvatures of monotonic bending at which the forces of the wires are listed",
             .unit = units::per_m,
             .at_least = 0});
  v.number("steps_per_cycle", a.steps_per_cycle, {.help = "the number of steps per cycle", .at_least = 8});
  v.choice("twist", a.twist, {.help = "whether the section may twist"});
  v.text("path", a.path,
         {.help = "the name of a csv file, beside the case, with any of the columns axial_strain or tension_N, "
                  "torsion_per_m, curvature_2_per_m, curvature_3_per_m"});
}

}  // namespace strandyn::casefile
