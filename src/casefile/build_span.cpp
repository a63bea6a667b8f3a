#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/casefile/build.hpp"
#include "strandyn/model/mesh.hpp"

namespace strandyn::casefile {
namespace {

/// What the keys may ask for and this version cannot do yet.
void refuse_what_is_missing(const Scene& scene) {
  const Span& span = *scene.span;
  const auto refuse_key = [&](bool asked, const char* key, const char* wrong, const char* right) {
    if (asked) refuse(scene.source, key, wrong, right);
  };
  refuse_key(span.dimension == Dimension::spatial, "span.dimension", "this version models planar spans",
             "use \"planar\"");
  refuse_key(!span.nodes.empty(), "span.nodes", "this version models straight spans", "give length_m in its place");
  refuse_key(span.gravity, "span.gravity", "this version models straight spans without self-weight", "use false");
  refuse_key(span.height_difference != 0, "span.height_difference_m", "this version models level spans", "use 0");
  refuse_key(span.condense_axial, "span.condense_axial", "this version keeps the axial unknowns", "use false");
  refuse_key(!scene.damping.modal.empty(), "damping.modal", "this version has drag as its only viscous damping",
             "use drag_N_s_per_m2");
  refuse_key(scene.damping.rayleigh.has_value(), "damping.rayleigh",
             "this version has drag as its only viscous damping", "use drag_N_s_per_m2");
  refuse_key(scene.integrator.method != Method::ida, "integrator.method", "this version integrates with IDA",
             "use \"ida\"");
  refuse_key(scene.integrator.step != StepRule::fixed, "integrator.step", "this version takes steps of equal length",
             "use \"fixed\" and choose steps_per_cycle");
  refuse_key(scene.integrator.checkpoint_every.has_value(), "integrator.checkpoint_every_s",
             "this version writes no checkpoints", "leave the key out");
  refuse_key(scene.static_.control != Control::load, "static.control", "this version controls the load",
             "use \"load\"");
}

/// [-] axial strain of the straight span.
double straight_strain(const Scene& scene, double EA) {
  const Span& span = *scene.span;
  if (const auto tension = span_tension(scene)) return *tension / EA;
  const double strain = *span.length / *span.unstressed_length - 1;
  if (strain < 0) {
    refuse(scene.source, "span.unstressed_length_m", "it is longer than the span: the conductor would hang slack",
           fmt::format("this version models straight spans: give at most {} m", *span.length));
  }
  return strain;
}

model::Support support(std::size_t node, Support kind) {
  switch (kind) {
    case Support::clamped:
      return {.node = node, .fixed = {true, true, true}};
    case Support::pinned:
      return {.node = node, .fixed = {true, true, false}};
    case Support::roller:
      return {.node = node, .fixed = {false, true, false}};
    case Support::free:
      break;
  }
  return {.node = node, .fixed = {false, false, false}};
}

/// A support that moves along the span holds no tension.
void refuse_lost_tension(const Scene& scene, double tension) {
  if (tension == 0) return;
  const auto check = [&](Support kind, const char* key) {
    if (kind != Support::roller && kind != Support::free) return;
    refuse(scene.source, key, fmt::format("it would let go of the tension of {:.4g} kN", tension / 1e3),
           "use \"clamped\" or \"pinned\", or a tension of 0");
  };
  check(scene.span->left, "span.left");
  check(scene.span->right, "span.right");
}

/// Mass moment of the section per length: that of the wires around the axis of bending, or from the stiffness where
/// densities are not known. [kg m]
double rotary_inertia(const Scene& scene, const SectionNumbers& numbers, double mass) {
  if (!scene.span->rotary_inertia) return 0;
  if (scene.conductor && scene.conductor->strand.geometric_mass()) {
    double sum = 0;
    for (const conductor::Layer& layer : scene.conductor->strand.layers) {
      const double around = layer.wire_inertia + layer.wire_area * layer.helix_radius * layer.helix_radius / 2;
      sum += layer.wires * layer.density * around / std::cos(layer.lay_angle);
    }
    return sum;
  }
  return mass * numbers.EI_max / numbers.EA;
}

/// Half a wave [m] at the highest frequency that the scene speaks of; a guess of the twelfth mode where it names none.
double shortest_loop(const Scene& scene, double tension) {
  const double length = *scene.span->length;
  double shortest = length / 12;
  const auto consider_mode = [&](int mode) { shortest = std::min(shortest, length / mode); };
  for (const Load& load : scene.loads) {
    if (load.frequency) shortest = std::min(shortest, loop_length(scene, tension, *load.frequency));
    if (load.frequency_mode) consider_mode(*load.frequency_mode);
  }
  if (scene.initial) consider_mode(scene.initial->velocity_mode);
  if (scene.analysis.type == AnalysisType::decay) consider_mode(scene.analysis.decay.mode);
  if (scene.analysis.type == AnalysisType::modes) consider_mode(scene.analysis.modes.count);
  return shortest;
}

std::vector<double> mesh(const Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const Span& span = *scene.span;
  const bool graded = span.grading == Grading::clamps && built.tension > 0;
  model::MeshOptions options{.length = *span.length,
                             .elements = 0,
                             .end_size = 0,
                             .grade_left = graded && span.left == Support::clamped,
                             .grade_right = graded && span.right == Support::clamped,
                             .growth = 0.25,
                             .stations = {}};
  // Half of the length within which bending dies out at a clamp when all wires slip there.
  if (graded) built.end_size = options.end_size = 0.5 * std::sqrt(numbers.EI_min / built.tension);
  for (const Load& load : scene.loads) {
    if (load.at) options.stations.push_back(*load.at);
  }
  constexpr double elements_per_loop = 10;
  options.elements = span.elements
                         ? static_cast<std::size_t>(*span.elements)
                         : model::elements_for(options, shortest_loop(scene, built.tension) / elements_per_loop);
  return model::span_mesh(options);
}

model::TimeFunction history_of(const Load& load) {
  if (load.type == LoadType::static_force) return model::Constant{};
  if (load.type == LoadType::harmonic_force) return model::Harmonic{.frequency = load.frequency.value_or(0)};
  model::Tabulated table;
  for (const auto& [time, value] : load.history) {
    table.time.push_back(time);
    table.value.push_back(value);
  }
  return table;
}

void add_load(BuiltSpan& built, std::size_t number, const Load& load, const Source& source) {
  const Vector3 direction = *load.direction;
  const double size = load.type == LoadType::table ? 1 : load.value();
  const Eigen::Vector3d amplitude = load.is_moment() ? Eigen::Vector3d(0, 0, size * direction[2])
                                                     : Eigen::Vector3d(size * direction[0], size * direction[1], 0);
  const double out_of_plane = load.is_moment() ? std::hypot(direction[0], direction[1]) : std::abs(direction[2]);
  if (out_of_plane > 0) {
    refuse(source, fmt::format("load[{}].direction", number), "a planar span moves in the x-y plane only",
           load.is_moment() ? "a moment acts about z: [0, 0, 1]" : "use a direction such as [0, 1, 0]");
  }
  const auto add = [&](std::size_t node, double share) {
    built.model.loads.push_back({.node = node, .amplitude = share * amplitude, .history = history_of(load)});
    built.load_of.push_back(number);
  };
  if (load.at) {
    const std::size_t node = model::nearest_node(built.model, *load.at);
    if (std::abs(built.model.nodes[node].x() - *load.at) > 1e-9 * built.length) {
      refuse(source, fmt::format("load[{}].at_m", number), "the mesh is too coarse to have a node there",
             "give more [span] elements, or move the load to a support or to another load");
    }
    add(node, 1);
    return;
  }
  const auto& nodes = built.model.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double left = i > 0 ? nodes[i].x() - nodes[i - 1].x() : 0;
    const double right = i + 1 < nodes.size() ? nodes[i + 1].x() - nodes[i].x() : 0;
    add(i, (left + right) / 2);
  }
}

}  // namespace

double wave_speed(const Scene& scene, double tension) {
  return std::sqrt(tension / *mass_per_length(scene));
}

double loop_length(const Scene& scene, double tension, double frequency) {
  return wave_speed(scene, tension) / (2 * frequency);
}

BuiltSpan build_span(const Scene& scene) {
  refuse_what_is_missing(scene);
  const SectionNumbers numbers = section_numbers(scene);
  const double strain = straight_strain(scene, numbers.EA);

  BuiltSpan built;
  built.length = *scene.span->length;
  built.tension = numbers.EA * strain;
  refuse_lost_tension(scene, built.tension);
  const std::vector<double> positions = mesh(scene, numbers, built);
  model::lay_out(built.model, {.positions = positions, .strain = strain});
  built.model.supports = {support(0, scene.span->left), support(positions.size() - 1, scene.span->right)};
  built.model.law = build_law(scene, section::Dimension::planar);
  built.model.inertia.mass = *mass_per_length(scene);
  built.model.inertia.rotary = rotary_inertia(scene, numbers, built.model.inertia.mass);
  const bool lumped = scene.span->mass == MassMatrix::lumped;
  built.model.mass_matrix = lumped ? model::MassMatrix::lumped : model::MassMatrix::consistent;
  built.model.drag = scene.damping.drag;
  for (std::size_t i = 0; i < scene.loads.size(); ++i) add_load(built, i, scene.loads[i], scene.source);
  return built;
}

void check_buildable(const Scene& scene) {
  const bool section_only =
      scene.analysis.type == AnalysisType::section || scene.analysis.type == AnalysisType::axial_torsion;
  if (section_only) {
    build_law(scene, scene.section.axial_resultants ? section::Dimension::spatial : section::Dimension::planar);
  } else {
    build_span(scene);
  }
}

void set_load_frequency(BuiltSpan& span, std::size_t load, double frequency) {
  for (std::size_t i = 0; i < span.model.loads.size(); ++i) {
    if (span.load_of[i] == load) span.model.loads[i].history = model::Harmonic{.frequency = frequency};
  }
}

}  // namespace strandyn::casefile
