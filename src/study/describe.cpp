#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "parts.hpp"
#include "self_damping_parts.hpp"
#include "strandyn/casefile/echo.hpp"

namespace strandyn::study {

using casefile::AnalysisType;
using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

json conductor_json(const Scene& scene) {
  const conductor::Strand& strand = scene.conductor->strand;
  json layers = json::array();
  for (const conductor::Layer& layer : strand.layers) {
    layers.push_back({{"wires", layer.wires},
                      {"wire_diameter_m", layer.diameter},
                      {"lay_angle_rad", layer.lay_angle},
                      {"helix_radius_m", layer.helix_radius},
                      {"young_Pa", layer.young},
                      {"residual_force_N_per_m", layer.residual_force},
                      {"friction_inner", layer.friction_inner}});
  }
  json out = {{"name", strand.name},
              {"outer_diameter_m", strand.outer_diameter()},
              {"mass_kg_per_m", strand.mass_per_length},
              {"rated_strength_N", strand.rated_strength}};
  if (const auto mass = strand.geometric_mass()) out["geometric_mass_kg_per_m"] = *mass;
  out["layers"] = layers;
  return out;
}

json mesh_json(const build::BuiltSpan& built, const build::SectionNumbers& numbers) {
  double shortest = built.length;
  double longest = 0;
  for (const beam::SpatialElement& element : built.model.elements) {
    shortest = std::min(shortest, element.span.norm());
    longest = std::max(longest, element.span.norm());
  }
  json out = {{"elements", built.model.elements.size()},
              {"unknowns", built.model.unknowns()},
              {"section_points", built.model.elements.size() * beam::gauss_points},
              {"shortest_element_m", shortest},
              {"longest_element_m", longest}};
  if (built.tension > 0) {
    out["boundary_layer_all_slipping_m"] = std::sqrt(numbers.EI_min / built.tension);
    out["boundary_layer_all_sticking_m"] = std::sqrt(numbers.EI_max / built.tension);
  }
  return out;
}

/// [s] of one evaluation of the forces of this very span, the shortest of a few.
double evaluation_time(const SpanAtRest& span) {
  system::Vector force(span.u.size());
  double best = 1;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    span.system.internal_force(span.u.data(), force.data());
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return best;
}

json vibration_json(const Scene& scene, SpanAtRest& span) {
  const VibrationPlan plan = plan_vibration(scene, span);
  const double steps = static_cast<double>(plan.cycles) * plan.steps_per_cycle();
  // Counted on slipping spans: two to three residuals a step, one for the ledger, one commit.
  constexpr double evaluations_per_step = 5;
  const double points = static_cast<double>(span.built.model.elements.size() * beam::gauss_points);
  json out = plan_json(plan);
  out["cycles"] = plan.cycles;
  out["until_steady"] = plan.until_steady;
  out["loop_length_m"] = build::loop_length(scene, span.built.tension, plan.frequency);
  out["expected_cost"] = {{"steps", steps},
                          {"section_evaluations", steps * evaluations_per_step * points},
                          {"wall_s_at_least", steps * evaluations_per_step * evaluation_time(span)}};
  return out;
}

}  // namespace

json describe_case(const Scene& scene) {
  json out;
  out["title"] = scene.title;
  out["analysis"] = casefile::name_of(scene.analysis.type);
  out["section_law"] = casefile::name_of(scene.section.law);
  if (scene.conductor) out["conductor"] = conductor_json(scene);
  const build::SectionNumbers n = build::section_numbers(scene);
  out["section"] = section_json(n);
  const AnalysisType type = scene.analysis.type;
  if (type == AnalysisType::section || type == AnalysisType::axial_torsion) {
    build::check_buildable(scene);
    return out;
  }
  if (type == AnalysisType::self_damping) {
    describe_self_damping(scene, out);
    return out;
  }
  SpanAtRest span(scene);
  out["span"] = {{"length_m", span.built.length},
                 {"tension_N", span.built.tension},
                 {"unstressed_length_m", span.built.model.unstressed_length()},
                 {"mass_kg_per_m", span.built.model.inertia.mass},
                 {"rotary_inertia_kg_m", span.built.model.inertia.rotary},
                 {"wave_speed_m_per_s", build::wave_speed(scene, span.built.tension)}};
  out["mesh"] = mesh_json(span.built, n);
  if (type == AnalysisType::decay || type == AnalysisType::forced) {
    span.apply_static_loads();
    out["vibration"] = vibration_json(scene, span);
  }
  return out;
}

}  // namespace strandyn::study
