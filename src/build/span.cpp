#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"

namespace strandyn::build {
namespace {

/// What the keys may ask for and this version cannot do yet.
void refuse_what_is_missing(const casefile::Scene& scene) {
  const auto refuse_key = [&](bool asked, const char* key, const char* wrong, const char* right) {
    if (asked) casefile::refuse(scene.source, key, wrong, right);
  };
  refuse_key(scene.integrator.method != casefile::Method::ida && scene.integrator.step == casefile::StepRule::adaptive,
             "integrator.step", "generalized-alpha takes steps of equal length",
             "use \"fixed\" or \"auto\", or method = \"ida\"");
  refuse_key(scene.integrator.checkpoint_every && scene.analysis.type == casefile::AnalysisType::transient,
             "integrator.checkpoint_every_s", "a transient analysis writes no checkpoints", "leave the key out");
}

/// Which motion the scene asks for; refuses pairs of keys that contradict each other.
model::Freedom freedom(const casefile::Scene& scene) {
  const casefile::Span& span = *scene.span;
  const bool spatial = span.dimension == casefile::Dimension::spatial;
  if (span.condense_axial) {
    if (spatial && span.torsion) {
      casefile::refuse(scene.source, "span.condense_axial", "a span that moves across its line only cannot twist",
                       "give torsion = false beside it");
    }
    if (scene.section.axial_resultants) {
      casefile::refuse(scene.source, "span.condense_axial", "the tension would depend on the bending of every section",
                       "leave section.axial_resultants out");
    }
    return spatial ? model::Freedom::transverse_spatial : model::Freedom::transverse_planar;
  }
  if (!spatial) return model::Freedom::planar;
  if (span.torsion) return model::Freedom::spatial;
  if (span.height_difference != 0) {
    casefile::refuse(scene.source, "span.torsion", "a span without torsion runs along x, and this one climbs",
                     "give height_difference_m = 0, or torsion = true");
  }
  return model::Freedom::spatial_untwisted;
}

/// A support that moves along the span holds no tension.
void refuse_lost_tension(const casefile::Scene& scene, double tension) {
  if (tension == 0) return;
  const auto check = [&](casefile::Support kind, const char* key) {
    if (kind == casefile::Support::clamped || kind == casefile::Support::pinned) return;
    casefile::refuse(scene.source, key, fmt::format("it would let go of the tension of {:.4g} kN", tension / 1e3),
                     "use \"clamped\" or \"pinned\", or a tension of 0");
  };
  check(scene.span->left, "span.left");
  check(scene.span->right, "span.right");
}

/// Mass moments of the section per length: those of the wires, or from the stiffness where densities are not known.
beam::SpatialSectionInertia section_inertia(const casefile::Scene& scene, const SectionNumbers& numbers) {
  const casefile::Span& span = *scene.span;
  beam::SpatialSectionInertia inertia{.mass = casefile::mass_per_length(scene).value_or(0), .rotary = 0, .polar = 0};
  double rotary = inertia.mass * numbers.EI_max / numbers.EA;
  if (scene.section.rotary_inertia) rotary = *scene.section.rotary_inertia;
  if (scene.conductor && scene.conductor->strand.geometric_mass()) {
    rotary = 0;
    for (const conductor::Layer& layer : scene.conductor->strand.layers) {
      const double around = layer.wire_inertia + layer.wire_area * layer.helix_radius * layer.helix_radius / 2;
      rotary += layer.wires * layer.density * around / std::cos(layer.lay_angle);
    }
  }
  if (span.rotary_inertia) inertia.rotary = rotary;
  // With consistent mass the twist of the chain needs an inertia of its own: the others leave it without.
  const bool twists = span.dimension == casefile::Dimension::spatial && span.torsion;
  if (twists && (span.rotary_inertia || span.mass == casefile::MassMatrix::consistent)) {
    inertia.polar = scene.section.polar_inertia.value_or(2 * rotary);
  }
  return inertia;
}

void lay_out_straight(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const casefile::Span& span = *scene.span;
  const Stringing stringing = find_stringing(scene, numbers.EA);
  const Eigen::Vector3d chord(*span.length, span.height_difference, 0);
  built.length = chord.norm();
  built.tension = stringing.tension;
  built.catenary_sag = stringing.catenary_sag;
  refuse_lost_tension(scene, built.tension);
  model::lay_out(built.model, model::StraightSpan{.positions = mesh_positions(scene, numbers, built),
                                                  .strain = built.length / stringing.unstressed_length - 1,
                                                  .direction = chord / built.length});
}

void lay_out_polyline(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const casefile::Span& span = *scene.span;
  const auto refuse_key = [&](bool given, const char* key) {
    if (given)
      casefile::refuse(scene.source, key, "a bend is laid out without stress", "leave it out, or give length_m");
  };
  refuse_key(span.tension.value_or(0) != 0, "span.tension_kN");
  refuse_key(span.tension_rts.value_or(0) != 0, "span.tension_rts");
  refuse_key(span.unstressed_length.has_value(), "span.unstressed_length_m");
  built.length = span.total_length();
  model::Polyline line;
  for (const casefile::Vector3& corner : span.nodes) line.corners.emplace_back(corner[0], corner[1], corner[2]);
  line.positions = mesh_positions(scene, numbers, built);
  model::lay_out(built.model, line);
}

}  // namespace

double wave_speed(const casefile::Scene& scene, double tension) {
  return std::sqrt(tension / *casefile::mass_per_length(scene));
}

double loop_length(const casefile::Scene& scene, double tension, double frequency) {
  return wave_speed(scene, tension) / (2 * frequency);
}

BuiltSpan build_span(const casefile::Scene& scene) {
  refuse_what_is_missing(scene);
  const SectionNumbers numbers = section_numbers(scene);
  BuiltSpan built;
  built.model.freedom = freedom(scene);
  const bool spatial = model::is_spatial(built.model.freedom);
  built.model.law = build_law(scene, spatial ? section::Dimension::spatial : section::Dimension::planar);
  if (scene.span->nodes.empty()) {
    lay_out_straight(scene, numbers, built);
  } else {
    lay_out_polyline(scene, numbers, built);
  }
  built.model.inertia = section_inertia(scene, numbers);
  const bool lumped = scene.span->mass == casefile::MassMatrix::lumped;
  built.model.mass_matrix = lumped ? model::MassMatrix::lumped : model::MassMatrix::consistent;
  built.model.drag = scene.damping.drag;
  add_supports(scene, built);
  add_loads(scene, built);
  add_motions(scene, built);
  add_bodies(scene, built);
  if (scene.span->gravity) {
    if (scene.span->nodes.empty()) {
      add_hanging_shape(scene, numbers, built);
    } else {
      // A frame under its weight: from where it stands.
      built.hanging = built.straight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(built.model.unknowns()));
    }
  }
  return built;
}

void check_buildable(const casefile::Scene& scene) {
  const bool section_only = scene.analysis.type == casefile::AnalysisType::section ||
                            scene.analysis.type == casefile::AnalysisType::axial_torsion ||
                            scene.analysis.type == casefile::AnalysisType::self_damping;
  if (section_only) {
    build_law(scene, scene.section.axial_resultants ? section::Dimension::spatial : section::Dimension::planar);
  } else {
    build_span(scene);
  }
}

}  // namespace strandyn::build
