#include "newton.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::solver {

using system::At;
using system::System;
using system::Vector;

system::Vector translations(const model::Model& model, const Vector& u) {
  Vector t = u;
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    if (model::is_rotation(model.kind(static_cast<std::size_t>(i)))) t(i) = 0;
  }
  return t;
}

PathNewton::PathNewton(const System& system, const EquilibriumOptions& options, Staging staging)
    : system_(system), options_(options), staging_(std::move(staging)), K_(system.make_matrix()) {}

At PathNewton::state(double factor) const {
  switch (staging_.stage) {
    case Stage::dead:
      return {.time = 0, .part = 0, .dead = factor};
    case Stage::supports:
      return {.time = 0, .part = 0, .dead = 1};
    case Stage::live:
      break;
  }
  return {.time = 0, .part = factor, .dead = 1};
}

PathNewton::Load PathNewton::load_at(const PathPoint& point) const {
  Load load{.force = system_.make_vector(), .slope = system_.make_vector()};
  Vector later = load.force;
  const auto fill = [&](double factor, Vector& force) {
    system_.external_force(state(factor), point.u.data(), force.data());
    system_.held_values(state(factor), force.data());
    if (staging_.stage == Stage::live) return;
    const double back = staging_.stage == Stage::dead ? 1 : 1 - factor;
    for (std::size_t i = 0; i < system_.unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (system_.is_held(i)) force(at) += back * (staging_.held_start(at) - force(at));
    }
  };
  fill(point.factor, load.force);
  fill(point.factor + 1, later);  // all of it is linear in the factor
  load.slope = later - load.force;
  return load;
}

void PathNewton::close(const PathPoint& point, const Condition& condition) {
  system_.subtract_external_tangent(state(point.factor), point.u.data(), K_);
  for (Eigen::Index i = 0; i < condition.drag.size(); ++i) {
    K_.add_at_node(static_cast<std::size_t>(i), static_cast<std::size_t>(i), condition.drag(i));
  }
  system_.hold(K_);
}

bool PathNewton::is_minimum(const PathPoint& point) {
  Vector internal = system_.make_vector();
  system_.internal_force(point.u.data(), internal.data(), K_);
  close(point, {});
  K_.make_symmetric();
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    if (system_.is_held(i)) K_.pin(i);
  }
  return math::negative_eigenvalues(K_) == 0;
}

std::optional<Vector> PathNewton::direction(const PathPoint& point) {
  Vector internal = system_.make_vector();
  system_.internal_force(point.u.data(), internal.data(), K_);
  close(point, {});
  if (!factors_.factorize(K_)) return std::nullopt;
  Vector slope = load_at(point).slope;
  factors_.solve(slope.data());
  return slope;
}

/// Is a correction of u too small to say anything? Without tension, what rounding leaves of the large axial stiffness
/// may exceed any fraction of the forces at work.
bool PathNewton::is_rounding(const Vector& correction, const Vector& u) const {
  constexpr double relative = 1e-11;
  const model::Model& model = system_.model();
  double reach = translations(model, u).lpNorm<Eigen::Infinity>();  // [m]
  for (const beam::SpatialElement& element : model.elements) reach = std::max(reach, element.length);
  for (Eigen::Index i = 0; i < correction.size(); ++i) {
    const double scale = model::is_rotation(model.kind(static_cast<std::size_t>(i))) ? 1 : reach;
    if (!(std::abs(correction(i)) <= relative * scale)) return false;
  }
  return true;
}

double PathNewton::slope(const PathPoint& point, const Condition& condition, const Vector& along) const {
  Vector force = system_.make_vector();
  system_.internal_force(point.u.data(), force.data());
  force -= load_at(point).force;
  if (condition.drag.size() > 0) force += condition.drag.cwiseProduct(point.u - condition.base);
  double slope = 0;
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (!system_.is_held(i)) slope += force(at) * along(at);
  }
  return slope;
}

double PathNewton::step_downhill(const PathPoint& point, const Condition& condition, const Vector& correction) const {
  constexpr double enough = 0.5;  // what may be left of the slope
  constexpr int most_trials = 12;
  const auto slope_at = [&](double part) {
    return slope({.u = point.u + part * correction, .factor = point.factor}, condition, correction);
  };
  const double start = slope_at(0);
  if (!(start < 0)) return 0;
  double low = 0, high = 1, low_slope = start, part = 1;
  for (int trial = 0; trial < most_trials; ++trial) {
    const double here = slope_at(part);
    if (here <= 0 && part == 1) return 1;
    if (std::abs(here) <= -enough * start) return part;
    double high_slope = here;
    if (here < 0) {
      low = part;
      low_slope = here;
      part = (low + high) / 2;
      continue;
    }
    high = part;
    // The chord to the end of the bracket, kept off its ends: the slope is far from straight.
    const double chord = low + (high - low) * low_slope / (low_slope - high_slope);
    part = std::clamp(chord, low + 0.1 * (high - low), low + 0.6 * (high - low));
  }
  return part;
}

NewtonResult PathNewton::iterate(PathPoint& point, const Condition& condition) {
  NewtonResult result;
  Vector internal = system_.make_vector();
  bool settled = false;
  const model::Model& model = system_.model();
  for (result.iterations = 0; result.iterations <= options_.max_iterations; ++result.iterations) {
    system_.internal_force(point.u.data(), internal.data(), K_);
    Load load = load_at(point);
    // Forces that are held in equilibrium, the tension first of all, set the scale of what rounding leaves over.
    double scale = internal.lpNorm<Eigen::Infinity>();
    Vector r = system_.make_vector();
    result.residual = 0;
    bool held_in_place = true;
    for (std::size_t i = 0; i < system_.unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (system_.is_held(i)) {
        r(at) = load.force(at) - point.u(at);
        held_in_place = held_in_place && std::abs(r(at)) <= 1e-14 * (1 + std::abs(point.u(at)));
        continue;
      }
      scale = std::max(scale, std::abs(load.force(at)));
      r(at) = load.force(at) - internal(at);
      if (condition.drag.size() > 0) r(at) -= condition.drag(at) * (point.u(at) - condition.base(at));
      if (!(std::abs(r(at)) <= result.residual)) {
        result.residual = std::abs(r(at));
        result.worst = i;
      }
      if (!std::isfinite(r(at))) return result;  // nothing that follows is worse
    }
    double gap = 0;  // of the condition, as a displacement
    const Vector moved =
        condition.control == Control::arc_length ? translations(model, point.u - condition.base) : Vector();
    if (condition.control == Control::displacement) {
      gap = condition.point.direction.dot(model.displacement(point.u.data(), condition.point.node)) -
            condition.point.target;
    } else if (condition.control == Control::arc_length) {
      gap = (moved.squaredNorm() / condition.arc - condition.arc) / 2;
    }
    const double size = std::max(std::abs(condition.point.target), condition.arc);
    const bool closed = std::abs(gap) <= 1e-9 * size && held_in_place;
    if (closed && (settled || result.residual <= options_.tolerance * scale)) {
      result.converged = true;
      result.is_rounding = settled;
      return result;
    }
    close(point, condition);
    if (!factors_.factorize(K_)) return result;
    factors_.solve(r.data());
    if (condition.control != Control::load) {
      factors_.solve(load.slope.data());
      const auto along = [&](const Vector& du) {
        if (condition.control == Control::arc_length) return moved.dot(du) / condition.arc;
        return condition.point.direction.dot(model.displacement(du.data(), condition.point.node));
      };
      const double change = -(gap + along(r)) / along(load.slope);
      if (!std::isfinite(change)) return result;
      point.factor += change;
      r += change * load.slope;
    }
    if (condition.downhill) {
      const double part = step_downhill(point, condition, r);
      if (part == 0) return result;  // the tangent is that of a crest
      r *= part;
    }
    point.u += r;
    result.corrections.push_back(r.norm());
    settled = is_rounding(r, point.u);
  }
  return result;
}

}  // namespace strandyn::solver
