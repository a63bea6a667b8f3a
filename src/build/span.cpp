#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "strandyn/build/losses.hpp"
#include "strandyn/build/wind.hpp"

namespace strandyn::build {
namespace {

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
  const std::vector<Stretch> stretches = stretches_of(scene, numbers.EA);
  const Stringing& stringing = stretches.front().stringing;
  const Eigen::Vector3d chord(*span.length, span.height_difference, 0);
  built.length = chord.norm();
  built.tension = stringing.tension;
  built.catenary_sag = stringing.catenary_sag;
  refuse_lost_tension(scene, built.tension);
  model::StraightSpan straight{.positions = mesh_positions(scene, numbers, built),
                               .strain = built.length / stringing.unstressed_length - 1,
                               .direction = chord / built.length};
  if (stretches.size() > 1 || !span.stretches.empty()) {
    std::size_t stretch = 0;
    for (std::size_t e = 0; e + 1 < straight.positions.size(); ++e) {
      const double middle = (straight.positions[e] + straight.positions[e + 1]) / 2;
      while (middle > stretches[stretch].to) ++stretch;
      const Stretch& here = stretches[stretch];
      const double strain = (here.to - here.from) / here.stringing.unstressed_length - 1;
      // One tension: another conductor stretches by another strain.
      straight.strains.push_back(strain * numbers.EA / axial_stiffness_at(scene, numbers, middle));
    }
  }
  model::lay_out(built.model, straight);
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

ProportionalDamping damping_of(const casefile::Scene& scene, const BuiltSpan& built) {
  ProportionalDamping damping;
  for (const auto& [mode, ratio] : scene.damping.modal) {
    damping.modes.push_back({.number = static_cast<int>(mode), .ratio = ratio});
    require_modes(scene, built, damping.modes.back().number, "damping.modal");
  }
  if (!scene.damping.rayleigh) return damping;
  damping.mass = scene.damping.rayleigh->mass;
  damping.stiffness = scene.damping.rayleigh->stiffness;
  const bool massless_rotations =
      built.model.mass_matrix == model::MassMatrix::lumped && built.model.inertia.rotary == 0;
  if (damping.stiffness > 0 && massless_rotations) {
    casefile::refuse(scene.source, "damping.rayleigh",
                     "rotations without inertia have no velocity that stiffness damping could act on",
                     "give [span] mass = \"consistent\", or rotary_inertia = true");
  }
  return damping;
}

}  // namespace

double BuiltSpan::wave_speed() const {
  return std::sqrt(tension / model.inertia.mass);
}

double loop_length(const casefile::Scene& scene, double tension, double frequency) {
  return std::sqrt(tension / *casefile::mass_per_length(scene)) / (2 * frequency);
}

BuiltSpan build_span(const casefile::Scene& scene) {
  const SectionNumbers numbers = section_numbers(scene);
  BuiltSpan built;
  built.numbers = numbers;
  built.model.freedom = freedom(scene);
  const bool spatial = model::is_spatial(built.model.freedom);
  built.model.law = build_law(scene, spatial ? section::Dimension::spatial : section::Dimension::planar);
  if (scene.span->nodes.empty()) {
    lay_out_straight(scene, numbers, built);
  } else {
    lay_out_polyline(scene, numbers, built);
  }
  built.model.inertia = section_inertia(scene, numbers);
  built.model.mass_matrix = scene.span->mass;
  built.model.drag = scene.damping.drag;
  built.model.surroundings = surroundings(scene);
  built.model.material = section::branches_of(material_loss(scene, built.tension));
  add_supports(scene, built);
  add_loads(scene, built);
  add_motions(scene, built);
  add_bodies(scene, built);
  add_stretches(scene, built.model);
  if (scene.span->gravity) add_weight(scene, built);
  built.model.wind = wind_of(scene, built.model);
  std::ranges::move(air_that_moves_along(built.model), std::back_inserter(built.model.bodies));
  built.damping = damping_of(scene, built);
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

void require_modes(const casefile::Scene& scene, const BuiltSpan& span, int number, const std::string& key) {
  const model::Model& model = span.model;
  std::size_t free = 0;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const auto holds = [&](const model::Support& support) {
      return support.node == node && support.fixed[static_cast<std::size_t>(model::Unknown::y)];
    };
    const auto moves = [&](const model::PrescribedMotion& motion) {
      return motion.node == node && motion.unknown == model::Unknown::y;
    };
    if (std::ranges::none_of(model.supports, holds) && std::ranges::none_of(model.motions, moves)) ++free;
  }
  // The highest shape of a mesh is the mesh's own, and the solver leaves it out.
  const int most = std::max(1, static_cast<int>(free) - 1);
  if (number <= most) return;
  casefile::refuse(
      scene.source, key,
      fmt::format("asks for mode {}, and a mesh of {} elements carries {} modes across the span at the most", number,
                  model.elements.size(), most),
      "give more [span] elements, or a lower mode");
}

}  // namespace strandyn::build
