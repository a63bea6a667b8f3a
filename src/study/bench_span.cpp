#include "bench_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "self_damping_periodic.hpp"
#include "shaken_span.hpp"
#include "strandyn/observe/deflection_points.hpp"

namespace strandyn::study {

using casefile::Scene;
using system::Vector;

namespace {

/// Of the first loop. In its middle the force is smallest, and strong damping lets it be tuned.
constexpr double shaker_place = 0.5;

/// Whose size the drives of an integration give.
Scene with_unit_shaker(Scene scene) {
  const Shaker shaker = shaker_of(scene);
  if (shaker.load) scene.loads[*shaker.load].amplitude = 1;
  if (shaker.motion) scene.motions[*shaker.motion].amplitude = 1;
  return scene;
}

}  // namespace

BenchSpan::BenchSpan(const Scene& scene, const Point& point)
    : mode_number_(span_of_point(scene, point).mode),
      scene_(with_unit_shaker(scene_of_point(scene, point, shaker_place))),
      span_(scene_) {
  span_.apply_static_loads();
  set_proportional_damping(scene_, span_);
  find_mode();

  const model::Model& model = span_.built.model;
  const Shaker shaker = shaker_of(scene_);
  moves_ = shaker.motion.has_value();
  const std::vector<std::size_t>& from = moves_ ? span_.built.motion_of : span_.built.load_of;
  const std::size_t key = moves_ ? *shaker.motion : *shaker.load;
  entry_ = static_cast<std::size_t>(std::ranges::find(from, key) - from.begin());
  node_ = moves_ ? model.motions[entry_].node : model.loads[entry_].node;
  shaker_position_ = model::arc_lengths(model)[node_];
  if (moves_) {
    const casefile::Vector3& axis = *scene_.motions[key].direction;
    sign_ = axis[0] + axis[1] + axis[2] > 0 ? 1 : -1;
  } else {
    direction_ = Eigen::Vector3d(scene_.loads[key].direction->data());
  }
  find_response();
}

void BenchSpan::find_mode() {
  const auto number = static_cast<std::size_t>(mode_number_);
  const solver::Mode mode = solver::transverse_modes(span_.system, span_.u, number)[number - 1];
  frequency_ = mode.frequency;
  loop_length_ = build::loop_length(scene_, span_.built.tension, frequency_);
  shape_ = mode.shape / observe::DeflectionPoints(span_.built.model, loop_length_).largest(mode.shape.data());
  system::Matrix M = span_.system.make_matrix();
  span_.system.mass_matrix(span_.u.data(), M);
  momentum_ = span_.system.make_vector();
  M.multiply(shape_.data(), momentum_.data());
  for (std::size_t i = 0; i < span_.system.unknowns(); ++i) {
    if (!span_.system.has_mass(i)) momentum_(static_cast<Eigen::Index>(i)) = 0;
  }
  modal_mass_ = shape_.dot(momentum_);
  sensor_ = momentum_ / modal_mass_;
}

/// What a drive of 1 does to the free unknowns, as forces; `dynamic` is K - w^2 M without supports.
Vector BenchSpan::unit_drive_force(system::Matrix& dynamic) const {
  const model::Model& model = span_.built.model;
  Vector force = span_.system.make_vector();
  if (moves_) {
    Vector motion = force;
    const auto moved = static_cast<Eigen::Index>(*model.index(node_, model.motions[entry_].unknown));
    motion(moved) = -sign_;
    dynamic.multiply(motion.data(), force.data());
  } else {
    for (int i = 0; i < 3; ++i) {
      const auto at = model.index(node_, static_cast<model::Unknown>(i));
      if (at) force(static_cast<Eigen::Index>(*at)) = direction_(i);
    }
  }
  for (std::size_t i = 0; i < span_.system.unknowns(); ++i) {
    if (span_.system.is_held(i)) force(static_cast<Eigen::Index>(i)) = 0;
  }
  return force;
}

/// (K - w^2 M) x = force, the mode's share taken out on both sides: there the matrix is singular.
void BenchSpan::find_response() {
  const double omega = 2 * std::numbers::pi * frequency_ * (1 + 1e-6);
  system::Matrix dynamic = span_.system.make_matrix();
  system::Matrix M = dynamic;
  Vector force = span_.system.make_vector();
  span_.system.internal_force(span_.u.data(), force.data(), dynamic);
  span_.system.subtract_external_tangent({.time = 0}, span_.u.data(), dynamic);
  dynamic.make_symmetric();
  span_.system.mass_matrix(span_.u.data(), M);
  dynamic.add(-omega * omega, M);

  force = unit_drive_force(dynamic);
  coupling_ = shape_.dot(force);
  if (coupling_ < 0) {
    shape_ = -shape_;
    momentum_ = -momentum_;
    sensor_ = -sensor_;
    coupling_ = -coupling_;
  }
  if (!moves_ && coupling_ < 1e-3) {
    throw ComputationError(
        fmt::format("the shaker at {:.4g} m stands at a node of mode {}: move it by a part of a loop", shaker_position_,
                    mode_number_));
  }
  response_ = force - momentum_ * (coupling_ / modal_mass_);
  span_.system.hold(dynamic);
  math::ChainFactors factors;
  if (!factors.factorize(dynamic)) throw ComputationError("the span's answer to the shaker could not be computed");
  factors.solve(response_.data());
  response_ -= sensor_.dot(response_) * shape_;
  if (moves_) {
    response_(static_cast<Eigen::Index>(*span_.built.model.index(node_, span_.built.model.motions[entry_].unknown))) =
        sign_;
  }
}

double BenchSpan::driven_displacement(const Vector& u) const {
  const model::Model& model = span_.built.model;
  if (moves_) {
    const auto at = static_cast<Eigen::Index>(*model.index(node_, model.motions[entry_].unknown));
    return sign_ * (u(at) - span_.u(at));
  }
  return direction_.dot(model.displacement(u.data(), node_) - model.displacement(span_.u.data(), node_));
}

double BenchSpan::shaker_force(const Vector& external_force) const {
  const model::Model& model = span_.built.model;
  if (moves_) {
    return sign_ * external_force(static_cast<Eigen::Index>(*model.index(node_, model.motions[entry_].unknown)));
  }
  return direction_.dot(model.displacement(external_force.data(), node_));
}

solver::InitialMotion BenchSpan::start(double antinode_amplitude, double drive_amplitude) const {
  return {.u = span_.u + drive_amplitude * response_,
          .v = antinode_amplitude * 2 * std::numbers::pi * frequency_ * shape_};
}

}  // namespace strandyn::study
