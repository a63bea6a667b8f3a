#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/exact/costello.hpp"
#include "strandyn/exact/full_slip.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;
using section::Component;
using section::Dimension;
using section::Field;

namespace {

/// One symmetric loop of curvature at constant tension.
struct Loop {
  double tension = 0;         ///< [N]
  double amplitude = 0;       ///< [1/m]
  double area = 0;            ///< [J/m] of the second cycle
  double largest_moment = 0;  ///< [N m] in it
};

std::vector<Loop> loops_of(const Scene& scene) {
  std::vector<Loop> loops;
  std::vector<double> tensions = casefile::section_tensions(scene);
  if (tensions.empty()) tensions.push_back(0);
  for (double tension : tensions) {
    for (double amplitude : scene.analysis.section.curvature_amplitudes) loops.push_back({tension, amplitude});
  }
  return loops;
}

/// chi/amplitude at a step of the path: 0, 1, -1, 1, -1, ... in straight lines, a quarter cycle to the first peak.
double triangle(int step, int steps_per_cycle) {
  const double phase = std::fmod(static_cast<double>(step) / steps_per_cycle, 1.0);
  if (phase <= 0.25) return 4 * phase;
  if (phase <= 0.75) return 2 - 4 * phase;
  return 4 * phase - 4;
}

/// All loops side by side, one section point each. The first cycle starts virgin; the second one is measured.
void march(const section::Law& law, std::vector<Loop>& loops, double EA, int steps_per_cycle, CaseResult& result) {
  results::Table history({"loop", "tension_N", "curvature_per_m", "moment_N_m"});
  Field strains(Dimension::planar, loops.size());
  Field stresses(Dimension::planar, loops.size());
  section::StepEnergy energy(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) strains[Component::axial][i] = loops[i].tension / EA;
  section::History memory = law.start(strains);
  section::Effort effort;
  const auto record = [&] {
    effort += law.respond(memory, strains, stresses, nullptr);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      history.append(std::array{static_cast<double>(i), loops[i].tension, strains[Component::bending2][i],
                                stresses[Component::bending2][i]});
    }
  };
  record();
  const int start_of_second = steps_per_cycle + steps_per_cycle / 4;  // peak to peak: a closed loop
  for (int step = 1; step <= start_of_second + steps_per_cycle; ++step) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      strains[Component::bending2][i] = loops[i].amplitude * triangle(step, steps_per_cycle);
    }
    effort += law.commit(memory, strains, energy);
    record();
    if (step < start_of_second) continue;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      loops[i].largest_moment = std::max(loops[i].largest_moment, stresses[Component::bending2][i]);
      // The trapezoidal work around a closed loop is what was dissipated less the error of the steps.
      if (step > start_of_second) loops[i].area += energy.dissipated[i] - energy.quadrature_error[i];
    }
  }
  result.summary["cost"]["steps"] = start_of_second + steps_per_cycle;
  result.summary["cost"]["section_evaluations"] = effort.evaluations;
  result.summary["cost"]["section_sweeps"] = effort.sweeps;
  result.tables.push_back({"loop.csv", std::move(history)});
}

}  // namespace

void run_section(const Scene& scene, CaseResult& result) {
  const casefile::SectionAnalysis& a = scene.analysis.section;
  if (a.path) {
    refuse(scene.source, "analysis.path", "this version follows symmetric cycles", "give curvature_amplitudes_per_m");
  }
  if (a.twist == casefile::Twist::free) {
    refuse(scene.source, "analysis.twist", "this version holds the twist of a section", "use \"held\"");
  }
  if (a.steps_per_cycle % 4 != 0) {
    refuse(scene.source, "analysis.steps_per_cycle", "the peaks of the path fall between steps",
           "give a multiple of 4");
  }
  std::vector<Loop> loops = loops_of(scene);
  const bool strand_known = scene.conductor.has_value();
  if (strand_known) {
    const exact::FullSlip slip =
        exact::full_slip_at_points(scene.conductor->strand, loops.front().tension, scene.section.points);
    result.summary["chi_0_per_m"] = slip.chi_0;
    result.summary["M_0_N_m"] = slip.M_0;
  }
  march(*casefile::build_law(scene), loops, casefile::section_numbers(scene).EA, a.steps_per_cycle, result);
  result.summary["loops"] = json::array();
  for (const Loop& loop : loops) {
    json entry = {{"tension_N", loop.tension},
                  {"curvature_per_m", loop.amplitude},
                  {"area_J_per_m", loop.area},
                  {"secant_stiffness_N_m2", loop.largest_moment / loop.amplitude}};
    if (strand_known) {
      const exact::FullSlip slip =
          exact::full_slip_at_points(scene.conductor->strand, loop.tension, scene.section.points);
      entry["chi_0_per_m"] = slip.chi_0;
      entry["M_0_N_m"] = slip.M_0;
    }
    result.summary["loops"].push_back(entry);
  }
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
