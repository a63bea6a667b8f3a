#pragma once
/// \file One symmetric cycle of a section alone, as summary.json and loops.csv have it.

#include <optional>

#include "strandyn/results/record.hpp"

namespace strandyn::study {

struct LoopRow {
  double tension = 0;
  std::optional<double> friction{};
  bool residual_forces = true;
  double curvature = 0, area = 0, secant = 0;
  std::optional<double> chi_0{}, M_0{}, over_chi_0{};
};
template <class V>
void members(V& v, LoopRow& l) {
  v.value("tension_N", l.tension, {.what = "the tension"});
  v.value("friction", l.friction, {.what = "the friction coefficient of all contacts, where it was varied"});
  v.value("residual_forces", l.residual_forces, {.what = "whether the residual forces of stranding act"});
  v.value("curvature_per_m", l.curvature, {.what = "amplitude of the symmetric cycle"});
  v.value("area_J_per_m", l.area, {.what = "of the second cycle: what friction takes", .shown = "loop area"});
  v.value("secant_stiffness_N_m2", l.secant, {.what = "largest moment over amplitude", .shown = "secant stiffness"});
  v.value("chi_0_per_m", l.chi_0, {.what = "yield curvature, of full slip"});
  v.value("M_0_N_m", l.M_0, {.what = "yield moment"});
  v.value("curvature_over_chi_0", l.over_chi_0, {.what = "the amplitude over the yield curvature"});
}

}  // namespace strandyn::study
