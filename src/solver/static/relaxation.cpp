#include "relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::solver {

using system::System;
using system::Vector;

namespace {

constexpr double farthest_turn = 0.25;  // [rad] of a node in a step: an element stays the shallow beam that it is
constexpr double nearest_turn = 0.02;   // [rad] steps as short as this are near enough for Newton's method
constexpr int most_steps = 1000;

/// Diagonal of D: [m] for displacements, [m^3] for rotations.
Vector drag_of(const model::Model& model, const System& system) {
  Vector drag = system.make_vector();
  std::vector<double> length(model.nodes.size(), 0);
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    length[e] += model.elements[e].length / 2;
    length[e + 1] += model.elements[e].length / 2;
  }
  for (Eigen::Index i = 0; i < drag.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double l = length[at / model.unknowns_per_node()];
    drag(i) = model::is_rotation(model.kind(at)) ? l * l * l : l;
  }
  return drag;
}

double largest_turn(const model::Model& model, const Vector& change) {
  return (change - translations(model, change)).lpNorm<Eigen::Infinity>();
}

}  // namespace

bool bends_little(const System& system, const Vector& u) {
  using section::Component;
  const model::Model& model = system.model();
  const auto dimension = model::is_spatial(model.freedom) ? section::Dimension::spatial : section::Dimension::planar;
  section::Field strains(dimension, model.elements.size() * beam::gauss_points);
  system.strains(u.data(), strains);
  for (const Component bending : {Component::bending2, Component::bending3}) {
    const AlignedVector& curvature = strains[bending];
    for (std::size_t point = 0; point < strains.points() && point < curvature.size(); ++point) {
      if (!(std::abs(curvature[point]) * model.elements[point / beam::gauss_points].length < 1)) return false;
    }
  }
  return true;
}

std::optional<Vector> relax(System& system, PathNewton& newton, Vector u) {
  const model::Model& model = system.model();
  system.held_values({.time = 0, .part = 0}, u.data());
  Vector load = system.make_vector();
  system.external_force({.time = 0, .part = 0}, u.data(), load.data());
  const double length = model.unstressed_length();
  // Under its own weight the chain would begin by sinking a hundredth of its length.
  const double first = translations(model, load).lpNorm<1>() / length / (0.01 * length);
  if (!(first > 0) || !u.allFinite()) return std::nullopt;
  Condition oil{.base = u, .drag = first * drag_of(model, system), .downhill = true};
  double alpha = 1;  // of `first`
  const Vector unit = oil.drag;
  for (int step = 0; step < most_steps; ++step) {
    oil.base = u;
    oil.drag = alpha * unit;
    PathPoint next{.u = u, .factor = 0};
    const bool found = newton.iterate(next, oil).converged;
    const double turn = found ? largest_turn(model, next.u - u) : 0;
    if (!found || turn > farthest_turn) {
      alpha *= 4;
      if (alpha > 1e12) return std::nullopt;
      continue;
    }
    u = next.u;
    if (turn < nearest_turn) {
      PathPoint rest{.u = u, .factor = 0};
      if (newton.iterate(rest, {.downhill = true}).converged && largest_turn(model, rest.u - u) < farthest_turn &&
          bends_little(system, rest.u)) {
        return rest.u;
      }
    }
    alpha /= 3;
  }
  return std::nullopt;
}

}  // namespace strandyn::solver
