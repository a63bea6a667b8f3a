#include "section_parts.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/exact/costello.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

AxialState axial_state(const build::SectionNumbers& n, casefile::Twist twist, double tension) {
  if (twist == casefile::Twist::held || n.C_AT == 0) return {.strain = tension / n.EA, .twist = 0};
  // Free to twist: M1 = C_AT eps + GJ chi1 = 0.
  const double strain = tension / (n.EA - n.C_AT * n.C_AT / n.GJ);
  return {.strain = strain, .twist = -n.C_AT * strain / n.GJ};
}

section::Dimension dimension_of(const Scene& scene) {
  const bool twists = scene.analysis.section.twist == casefile::Twist::free;
  return twists || scene.section.axial_resultants ? section::Dimension::spatial : section::Dimension::planar;
}

void run_section(const Scene& scene, CaseResult& result) {
  if (scene.analysis.section.path) {
    run_section_path(scene, result);
  } else {
    run_section_cycles(scene, result);
  }
  list_wires(scene, result);
}

void run_axial_torsion(const Scene& scene, CaseResult& result) {
  if (!scene.conductor) {
    refuse(scene.source, "analysis.type", "tension and torsion need the wires of a strand", "give a [conductor]");
  }
  const conductor::Strand& strand = scene.conductor->strand;
  const conductor::SectionConstants c = conductor::section_constants(strand);
  json fixed = {{"seed", {{"k1_N", c.EA}}}};
  json free = {{"seed", {{"k1_N", c.EA_free_end()}}}};
  if (c.C_AT != 0) fixed["seed"]["k2_per_m"] = c.EA / c.C_AT;
  if (strand.layers.size() == 2) {
    // Costello's equations in the form used here are those of a core and one layer.
    const double strain = scene.analysis.axial_torsion.axial_strain;
    const auto held = exact::costello(strand, {.strain = strain, .twist = 0}, exact::Contraction::poisson);
    const auto loose = exact::costello_free_end(strand, strain, exact::Contraction::poisson);
    fixed["costello"] = {{"k1_N", held.k1()}, {"k2_per_m", held.k2()}};
    free["costello"] = {{"k1_N", loose.k1()}};
  }
  result.summary["fixed_end"] = fixed;
  result.summary["free_end"] = free;
}

}  // namespace strandyn::study
