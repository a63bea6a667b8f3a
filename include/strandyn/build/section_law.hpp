#pragma once
/// \file From a scene to its section law, and the numbers of the section that everything else refers to.

#include <memory>
#include <optional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::build {

struct SectionNumbers {
  double EA = 0;        ///< [N]
  double GJ = 0;        ///< [N m^2]
  double C_AT = 0;      ///< [N m]
  double EI_min = 0;    ///< [N m^2] for laws without a strand: what remains when all slips
  double EI_max = 0;    ///< [N m^2] what acts while nothing slips
  double diameter = 0;  ///< [m] outer; 0 where no conductor is given
};
SectionNumbers section_numbers(const casefile::Scene& scene);

/// `section` of summary.json.
template <class V>
void members(V& v, SectionNumbers& n) {
  v.value("EA_N", n.EA, {.what = "the axial stiffness"});
  v.value("GJ_N_m2", n.GJ, {.what = "the torsional stiffness"});
  v.value("C_AT_N_m", n.C_AT, {.what = "the coupling of tension and torsion"});
  v.value("EI_min_N_m2", n.EI_min, {.what = "the bending stiffness when all wires slip"});
  v.value("EI_max_N_m2", n.EI_max, {.what = "the bending stiffness when all wires stick"});
}

/// Whether the wires of such a law can be looked at (section::Law::wires).
bool has_wires(casefile::Law law);

/// Whether what slips depends on the points of a section.
bool slips_by_points(casefile::Law law);

/// The next finer number of points of a turn: the battery of the section laws knows these. 72 and more have none.
std::optional<int> finer_points(int points);

/// The law of the scene; `strand`, where given, stands for the scene's own (a variant of it). Throws InputError at the
/// key that asks for what the law cannot do.
std::shared_ptr<const section::Law> build_law(const casefile::Scene& scene, section::Dimension dimension,
                                              const conductor::Strand* strand = nullptr);

}  // namespace strandyn::build
