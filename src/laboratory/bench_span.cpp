#include "strandyn/laboratory/bench_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/span/damping.hpp"
#include "strandyn/span/modes.hpp"

namespace strandyn::laboratory {

using system::Vector;

namespace {

/// Drives of an integration give the size of the shaker.
build::BuiltSpan with_unit_shaker(build::BuiltSpan built, const build::Shaker& shaker) {
  if (shaker.moves) {
    built.model.motions[shaker.entry].amplitude = shaker.sign;
  } else {
    built.model.loads[shaker.entry].force = shaker.direction();
  }
  return built;
}

}  // namespace

BenchSpan::BenchSpan(build::BuiltSpan built, const build::Shaker& shaker, int mode)
    : mode_number_(mode), span_(with_unit_shaker(std::move(built), shaker)), shaker_(shaker) {
  span_.apply_static_loads();
  span::set_proportional_damping(span_);
  find_mode();
  span_.system.set_swing(frequency_);
  find_response();
}

void BenchSpan::find_mode() {
  const std::vector<solver::Mode> modes = span::modes_across(span_, mode_number_);
  const solver::Mode& mode = modes.back();
  frequency_ = mode.frequency;
  if (modes.size() > 1) round_trip_ = frequency_ / (frequency_ - modes[modes.size() - 2].frequency);
  loop_length_ = span_.built.loop_length(frequency_);
  shape_ = span::unit_antinode(span_, mode);
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
  if (shaker_.moves) {
    Vector motion = force;
    const auto moved = static_cast<Eigen::Index>(*model.index(shaker_.node, model.motions[shaker_.entry].unknown));
    motion(moved) = -shaker_.sign;
    dynamic.multiply(motion.data(), force.data());
  } else {
    for (int i = 0; i < 3; ++i) {
      const auto at = model.index(shaker_.node, static_cast<model::Unknown>(i));
      if (at) force(static_cast<Eigen::Index>(*at)) = shaker_.direction()(i);
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
  if (!shaker_.moves && coupling_ < 1e-3) {
    throw ComputationError(
        fmt::format("the shaker at {:.4g} m stands at a node of mode {}: move it by a part of a loop",
                    shaker_position(), mode_number_));
  }
  response_ = force - momentum_ * (coupling_ / modal_mass_);
  span_.system.hold(dynamic);
  math::ChainFactors factors;
  if (!factors.factorize(dynamic)) throw ComputationError("the span's answer to the shaker could not be computed");
  factors.solve(response_.data());
  response_ -= sensor_.dot(response_) * shape_;
  if (shaker_.moves) {
    response_(static_cast<Eigen::Index>(
        *span_.built.model.index(shaker_.node, span_.built.model.motions[shaker_.entry].unknown))) = shaker_.sign;
  }
}

double BenchSpan::shaker_position() const {
  return model::arc_lengths(span_.built.model)[shaker_.node];
}

double BenchSpan::driven_displacement(const Vector& u) const {
  const model::Model& model = span_.built.model;
  if (shaker_.moves) {
    const auto at = static_cast<Eigen::Index>(*model.index(shaker_.node, model.motions[shaker_.entry].unknown));
    return shaker_.sign * (u(at) - span_.u(at));
  }
  return shaker_.direction().dot(model.displacement(u.data(), shaker_.node) -
                                 model.displacement(span_.u.data(), shaker_.node));
}

double BenchSpan::shaker_force(const Vector& external_force) const {
  const model::Model& model = span_.built.model;
  if (shaker_.moves) {
    return shaker_.sign *
           external_force(static_cast<Eigen::Index>(*model.index(shaker_.node, model.motions[shaker_.entry].unknown)));
  }
  return shaker_.direction().dot(model.displacement(external_force.data(), shaker_.node));
}

solver::InitialMotion BenchSpan::start(double antinode_amplitude, double drive_amplitude) const {
  return {.u = span_.u + drive_amplitude * response_,
          .v = antinode_amplitude * 2 * std::numbers::pi * frequency_ * shape_};
}

}  // namespace strandyn::laboratory
