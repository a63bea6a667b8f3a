#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "strandyn/model/mesh.hpp"

namespace strandyn::build {

using model::Unknown;

namespace {

Eigen::Vector3d vector(const casefile::Vector3& v) {
  return {v[0], v[1], v[2]};
}

/// In the order of model::Unknown. A support that holds a place holds the twist there; only a free end twists.
model::Support support(std::size_t node, casefile::Support kind) {
  switch (kind) {
    case casefile::Support::clamped:
      return {.node = node, .fixed = {true, true, true, true, true, true}};
    case casefile::Support::pinned:
      return {.node = node, .fixed = {true, true, true, true, false, false}};
    case casefile::Support::roller:
      return {.node = node, .fixed = {false, true, true, true, false, false}};
    case casefile::Support::guided:
      return {.node = node, .fixed = {false, true, true, true, true, true}};
    case casefile::Support::free:
      break;
  }
  return {.node = node, .fixed = {}};
}

/// The node at a distance [m] from the left support.
std::size_t node_at(const casefile::Scene& scene, const BuiltSpan& built, double at, const std::string& key) {
  const std::size_t node = model::nearest_node(built.model, at);
  if (std::abs(model::arc_lengths(built.model)[node] - at) > model::same_place(built.length)) {
    casefile::refuse(scene.source, key, "the mesh is too coarse to have a node there",
                     "give more [span] elements, or move it to a support or to another load");
  }
  return node;
}

/// That of the case, or a new drive of the span at the frequency that a harmonic load or motion asks for.
template <class Source>
model::TimeFunction history_of(const Source& source, BuiltSpan& built) {
  if (!source.is_harmonic()) return source.history_function();
  built.drives.push_back({.frequency = source.frequency, .mode = source.frequency_mode});
  return model::Driven{.drive = built.drives.size() - 1};
}

/// [m] of the reference configuration that each node stands for.
std::vector<double> tributary_lengths(const model::Model& model) {
  std::vector<double> share(model.nodes.size(), 0.0);
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    for (std::size_t node : {e, e + 1}) share[node] += model.elements[e].span.norm() / 2;
  }
  return share;
}

/// The span moves in the plane of x and y only; then so does what acts on it.
void refuse_out_of_plane(const casefile::Scene& scene, double out_of_plane, const std::string& key, bool turns) {
  if (scene.span->dimension == casefile::Dimension::spatial || out_of_plane == 0) return;
  casefile::refuse(scene.source, key, "a planar span moves in the x-y plane only",
                   turns ? "turn about z: [0, 0, 1]" : "use a direction such as [0, 1, 0]");
}

/// A force on a point that supports hold moves nothing.
void refuse_on_support(const casefile::Scene& scene, const BuiltSpan& built, std::size_t number, std::size_t node,
                       const Eigen::Vector3d& direction, bool turns) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto unknown = static_cast<Unknown>(axis + (turns ? 3 : 0));
    if (direction(axis) == 0 || !built.model.index(node, unknown)) continue;
    const auto holds = [&](const model::Support& support) {
      return support.node == node && support.fixed[static_cast<std::size_t>(unknown)];
    };
    if (std::ranges::none_of(built.model.supports, holds)) return;
  }
  casefile::refuse(scene.source, fmt::format("load[{}].at_m", number),
                   fmt::format("a support holds this point: a {} there moves nothing", turns ? "moment" : "force"),
                   "move it away from the support, or give a [[motion]] of the support instead");
}

}  // namespace

void add_supports(const casefile::Scene& scene, BuiltSpan& built) {
  built.model.supports = {support(0, scene.span->left), support(built.model.nodes.size() - 1, scene.span->right)};
  double from = 0;
  for (std::size_t number = 0; number < scene.span->supports.size(); ++number) {
    const casefile::SuspensionKeys& keys = scene.span->supports[number];
    const std::size_t node = node_at(scene, built, keys.at, fmt::format("span.support[{}].at_m", number));
    const bool is_string = keys.type == casefile::Suspension::string;
    model::Support held = support(
        node, keys.type == casefile::Suspension::clamped ? casefile::Support::clamped : casefile::Support::pinned);
    if (is_string) {
      // A pendulum: it swings along the line, under the weight of half a span on either side and half of its own.
      const double to =
          number + 1 < scene.span->supports.size() ? scene.span->supports[number + 1].at : *scene.span->length;
      const double mass = casefile::mass_per_length(scene).value_or(0) * (to - from) / 2 + keys.string_mass / 2;
      held.fixed[static_cast<std::size_t>(Unknown::x)] = false;
      built.model.bodies.push_back({.node = node,
                                    .mass = keys.string_mass / 3,
                                    .stiffness = mass * gravity / keys.string_length,
                                    .direction = Eigen::Vector3d::UnitX()});
    }
    built.model.supports.push_back(held);
    from = keys.at;
  }
}

void add_loads(const casefile::Scene& scene, BuiltSpan& built) {
  for (std::size_t number = 0; number < scene.loads.size(); ++number) {
    const casefile::Load& load = scene.loads[number];
    const Eigen::Vector3d direction = vector(*load.direction);
    const bool turns = load.is_moment();
    refuse_out_of_plane(scene, turns ? direction.head<2>().norm() : std::abs(direction.z()),
                        fmt::format("load[{}].direction", number), turns);
    const double size = load.value();
    const model::TimeFunction history = history_of(load, built);
    const auto add = [&](std::size_t node, double share) {
      const Eigen::Vector3d value = share * size * direction;
      const Eigen::Vector3d none = Eigen::Vector3d::Zero();
      built.model.loads.push_back({.node = node,
                                   .force = turns ? none : value,
                                   .moment = turns ? value : none,
                                   .history = history,
                                   .dead = false});
      built.load_of.push_back(number);
    };
    if (load.at) {
      const std::size_t node = node_at(scene, built, *load.at, fmt::format("load[{}].at_m", number));
      refuse_on_support(scene, built, number, node, direction, turns);
      add(node, 1);
      continue;
    }
    const std::vector<double> share = tributary_lengths(built.model);
    for (std::size_t i = 0; i < share.size(); ++i) add(i, share[i]);
  }
}

void add_weight(const casefile::Scene& scene, BuiltSpan& built) {
  model::Model& model = built.model;
  const double weight = *casefile::mass_per_length(scene) * gravity;
  const double pull = wind_load(scene);
  const auto add = [&](std::size_t node, const Eigen::Vector3d& force) {
    model.loads.push_back({.node = node, .force = force, .dead = true});
    built.load_of.push_back(scene.loads.size());  // none of them
  };
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double share = model.elements[e].length / 2;
    for (std::size_t node : {e, e + 1}) add(node, {0, -weight * share, pull * share});
  }
  for (const model::Body& body : model.bodies) {
    if (body.mass > 0) add(body.node, {0, -gravity * body.mass, 0});
  }
  for (const casefile::DamperKeys& damper : scene.dampers) {
    double hung = 0;  // its clamp is a body
    for (std::size_t i = 0; i < damper.lengths.size(); ++i) {
      hung += damper.masses[i] + *damper.messenger->mass_per_length * damper.lengths[i];
    }
    add(model::nearest_node(model, damper.at), {0, -gravity * hung, 0});
  }
}

void add_motions(const casefile::Scene& scene, BuiltSpan& built) {
  for (std::size_t number = 0; number < scene.motions.size(); ++number) {
    const casefile::Motion& motion = scene.motions[number];
    const std::string key = fmt::format("motion[{}]", number);
    const Eigen::Vector3d direction = vector(*motion.direction);
    const bool turns = motion.is_rotation();
    refuse_out_of_plane(scene, turns ? direction.head<2>().norm() : std::abs(direction.z()), key + ".direction", turns);
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const auto unknown = static_cast<Unknown>(axis + (turns ? 3 : 0));
    std::size_t node = motion.support == casefile::End::right ? built.model.nodes.size() - 1 : 0;
    if (!motion.support) node = node_at(scene, built, *motion.at, key + ".at_m");
    if (!built.model.index(node, unknown)) {
      casefile::refuse(scene.source, key + ".direction", fmt::format("this span has no {}", model::name_of(unknown)),
                       "give another direction, or leave condense_axial and torsion = false out of [span]");
    }
    built.model.motions.push_back({.node = node,
                                   .unknown = unknown,
                                   .amplitude = direction(axis) * motion.value(),
                                   .history = history_of(motion, built),
                                   .ease = {.duration = motion.ease}});
    built.motion_of.push_back(number);
  }
}

void add_bodies(const casefile::Scene& scene, BuiltSpan& built) {
  for (std::size_t number = 0; number < scene.bodies.size(); ++number) {
    const casefile::Body& body = scene.bodies[number];
    built.model.bodies.push_back({.node = node_at(scene, built, body.at, fmt::format("body[{}].at_m", number)),
                                  .mass = body.mass,
                                  .inertia = body.inertia,
                                  .stiffness = body.stiffness,
                                  .damping = body.damping,
                                  .direction = vector(*body.direction)});
  }
  for (std::size_t number = 0; number < scene.dampers.size(); ++number) {
    const casefile::DamperKeys& damper = scene.dampers[number];
    built.model.bodies.push_back(
        {.node = node_at(scene, built, damper.at, fmt::format("damper[{}].at_m", number)), .mass = *damper.clamp_mass});
  }
}

}  // namespace strandyn::build
