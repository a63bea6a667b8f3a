// Chains that hang under their weight.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "strandyn/exact/elastic_catenary.hpp"
#include "strandyn/solver/static/equilibrium.hpp"
#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Unknown;
using strandyn::solver::find_rest;
using strandyn::solver::RestingShape;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::place;
using strandyn::test::zeros;

namespace {

struct Cable {
  double span = 0;    // [m] between level pins
  double length = 0;  // [m] unstressed
  double weight = 0;  // [N/m]
  double EA = 0;
  double EI = 0;
  std::size_t elements = 0;

  exact::ElasticCatenary catenary() const {
    return exact::ElasticCatenary::from_unstressed_length(
        {.span = span, .height_difference = 0, .weight_per_length = weight}, EA, length);
  }
};

model::Model hanging(const Cable& cable) {
  model::Model model;
  const double n = static_cast<double>(cable.elements);
  std::vector<double> positions;
  for (std::size_t i = 0; i <= cable.elements; ++i) positions.push_back(cable.span * static_cast<double>(i) / n);
  model::lay_out(model, {.positions = positions, .strain = cable.span / cable.length - 1});
  const std::array<bool, 6> pin = {true, true, true, true, true, false};
  model.supports = {{.node = 0, .fixed = pin}, {.node = cable.elements, .fixed = pin}};
  model.law = test::linear_law(cable.EA, cable.EI);
  model.inertia = {.mass = cable.weight / 9.80665};
  for (std::size_t i = 0; i <= cable.elements; ++i) {
    const double share = i == 0 || i == cable.elements ? 0.5 : 1;
    model.loads.push_back({.node = i, .force = {0, -share * cable.weight * cable.length / n, 0}, .dead = true});
  }
  return model;
}

/// The catenary, and the straight chain from the left support, taut by its own weight.
RestingShape shapes(const Cable& cable, const model::Model& model) {
  RestingShape shape{.guess = zeros(model), .straight = zeros(model)};
  const auto catenary = cable.catenary();
  const double taut = 1 + cable.weight * cable.length / cable.EA;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const double s = cable.length * static_cast<double>(i) / static_cast<double>(cable.elements);
    const auto at = catenary.at(s);
    shape.straight(place(model, i, Unknown::x)) = taut * s - model.nodes[i].x();
    shape.guess(place(model, i, Unknown::x)) = at.x - model.nodes[i].x();
    shape.guess(place(model, i, Unknown::y)) = at.y;
    shape.guess(place(model, i, Unknown::rotation_z)) = at.angle;
  }
  return shape;
}

double sag(const model::Model& model, const Vector& u) {
  return -u(place(model, model.nodes.size() / 2, Unknown::y));
}

/// Largest force that is not in balance. [N]
double unbalanced(const System& system, const Vector& u) {
  Vector f = system.make_vector();
  Vector load = f;
  system.internal_force(u.data(), f.data());
  system.external_force({.time = 0, .part = 0}, u.data(), load.data());
  f -= load;
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (system.is_held(i)) f(static_cast<Eigen::Index>(i)) = 0;
  }
  return f.lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("rest: a hanging span found from its guess is the one found from the straight chain") {
  const Cable cable{.span = 200, .length = 200.4, .weight = 19.4, .EA = 47e6, .EI = 2000, .elements = 40};
  const model::Model model = hanging(cable);
  RestingShape shape = shapes(cable, model);
  System system(model);
  const Vector from_guess = find_rest(system, shape);
  CHECK(unbalanced(system, from_guess) <= 1e-5);  // of a tension of 40 kN
  shape.guess.setConstant(std::numeric_limits<double>::quiet_NaN());
  System again(model);
  const Vector from_straight = find_rest(again, shape);
  CHECK((from_guess - from_straight).lpNorm<Eigen::Infinity>() <= 1e-8);
  // Bending stiffness lifts the sag by sqrt(EI/H)/L-parts, chords by (1/40)^2.
  check_close(sag(model, from_guess), cable.catenary().sag(), {.relative = 2e-3});
}

TEST_CASE("rest: friction of a hanging strand does not depend on the way to its shape") {
  // Begun in one step from the straight to the answer, whichever state the search began with.
  const Cable cable{.span = 30, .length = 30.05, .weight = 19.4, .EA = 47e6, .EI = 2000, .elements = 20};
  model::Model model = hanging(cable);
  model.law = test::return_map();
  RestingShape shape = shapes(cable, model);
  System system(model);
  const Vector from_guess = find_rest(system, shape);
  shape.guess.setConstant(std::numeric_limits<double>::quiet_NaN());
  System again(model);
  const Vector from_straight = find_rest(again, shape);
  CHECK((from_guess - from_straight).lpNorm<Eigen::Infinity>() <= 1e-8);
  CHECK(unbalanced(system, from_guess) <= 1e-4);
  CHECK(unbalanced(again, from_straight) <= 1e-4);
}

TEST_CASE("rest: a slack cable one metre long hangs between supports one millimetre apart") {
  // Its bend at the bottom is as wide as (EI/w)^(1/3) = 46 mm allows: far from any catenary.
  const Cable cable{.span = 1e-3, .length = 1, .weight = 1, .EA = 1e4, .EI = 1e-4, .elements = 160};
  const model::Model model = hanging(cable);
  System system(model);
  const Vector u = find_rest(system, shapes(cable, model));
  CHECK(unbalanced(system, u) <= 1e-7);
  CHECK(sag(model, u) > 0.4);
  CHECK(sag(model, u) < 0.5);
  double widest = 0;
  for (std::size_t i = 0; i <= 160; ++i) {
    const double x = model.nodes[i].x() + u(place(model, i, Unknown::x));
    const double mirrored = model.nodes[160 - i].x() + u(place(model, 160 - i, Unknown::x));
    check_close(x + mirrored, cable.span, {.absolute = 1e-7});
    check_close(u(place(model, i, Unknown::y)), u(place(model, 160 - i, Unknown::y)), {.absolute = 1e-7});
    widest = std::max(widest, mirrored - x);
  }
  CHECK(widest > 0.03);
  CHECK(widest < 0.2);
  // Each support carries half of the weight.
  Vector f = zeros(model);
  system.internal_force(u.data(), f.data());
  check_close(f(1), 0.5 - 0.5 / 160, {.absolute = 1e-6});
}

namespace {

struct ClampedStrand {
  double EI = 0, moment = 0, tension = 0;  // [N m2]; [N m] at the clamps and [N] near the answer
};
constexpr double clamped_span = 10, clamped_length = 10.8, clamped_weight = 1.981 * 9.80665;

/// An inextensible elastica of half the length, clamped level at its left end: its slope at the other end, and what it
/// lacks of half the span. Equilibrium of moments: EI theta'' = H sin(theta) - w (s - S/2) cos(theta).
std::array<double, 2> missed(const ClampedStrand& c) {
  constexpr int steps = 2000;
  constexpr double half = clamped_length / 2, h = half / steps;
  using State = Eigen::Vector3d;  // theta, M, x
  const auto rate = [&](double s, const State& y) {
    return State(y(1) / c.EI, c.tension * std::sin(y(0)) - clamped_weight * (s - half) * std::cos(y(0)),
                 std::cos(y(0)));
  };
  State y(0, c.moment, 0);
  for (int i = 0; i < steps; ++i) {
    const double s = h * i;
    const State k1 = rate(s, y), k2 = rate(s + h / 2, y + h / 2 * k1), k3 = rate(s + h / 2, y + h / 2 * k2);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(s + h, y + h * k3));
  }
  return {y(0), y(2) - clamped_span / 2};
}

/// Shooting for both unknowns. [N]
double tension_of_elastica(ClampedStrand c) {
  for (int round = 0; round < 50; ++round) {
    const auto r = missed(c);
    if (std::abs(r[0]) + std::abs(r[1]) < 1e-11) return c.tension;
    constexpr double d = 1e-5;
    ClampedStrand m = c, t = c;
    m.moment += d;
    t.tension += d;
    const auto by_m = missed(m), by_t = missed(t);
    Eigen::Matrix2d J;
    J << by_m[0] - r[0], by_t[0] - r[0], by_m[1] - r[1], by_t[1] - r[1];
    const Eigen::Vector2d change = -d * J.inverse() * Eigen::Vector2d(r[0], r[1]);
    c.moment += change(0);
    c.tension += change(1);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The same strand as a chain, whose catenary knows nothing of the clamps. [N] horizontal tension of its rest.
double tension_of_chain(double EI, std::size_t elements) {
  const Cable cable{.span = clamped_span,
                    .length = clamped_length,
                    .weight = clamped_weight,
                    .EA = 47e6,
                    .EI = EI,
                    .elements = elements};
  model::Model model = hanging(cable);
  for (model::Support& support : model.supports) support.fixed.back() = true;
  RestingShape shape = shapes(cable, model);
  for (const model::Support& support : model.supports) shape.guess(place(model, support.node, Unknown::rotation_z)) = 0;
  System system(model);
  const Vector u = find_rest(system, shape);
  CHECK(unbalanced(system, u) <= 1e-6);
  Vector f = zeros(model);
  system.internal_force(u.data(), f.data());
  return f(place(model, elements, Unknown::x));
}

}  // namespace

TEST_CASE("rest: bending rules the tension of a slack strand between clamps") {
  for (const ClampedStrand& c : {ClampedStrand{.EI = 1500, .moment = -562, .tension = -413},
                                 ClampedStrand{.EI = 300, .moment = -166, .tension = 8.9}}) {
    CAPTURE(c.EI);
    const double expected = tension_of_elastica(c);
    for (const std::size_t elements : {20, 40, 80}) {
      CAPTURE(elements);
      // The tension is what two forces of 150 N leave over.
      check_close(tension_of_chain(c.EI, elements), expected, {.relative = 1e-3, .absolute = 0.02});
    }
  }
}

TEST_CASE("rest: a slack strand with friction between clamps hangs alike on any mesh") {
  const Cable cable{
      .span = clamped_span, .length = clamped_length, .weight = clamped_weight, .EA = 47e6, .EI = 35, .elements = 40};
  std::vector<double> sags;
  for (const std::size_t elements : {20, 40, 80}) {
    Cable strand = cable;
    strand.elements = elements;
    model::Model model = hanging(strand);
    for (model::Support& support : model.supports) support.fixed.back() = true;
    model.law = test::return_map();
    RestingShape shape = shapes(strand, model);
    for (const model::Support& s : model.supports) shape.guess(place(model, s.node, Unknown::rotation_z)) = 0;
    System system(model);
    const Vector u = find_rest(system, shape);
    CHECK(unbalanced(system, u) <= 1e-4);
    sags.push_back(sag(model, u));
  }
  // Deeper than the catenary, whose ends are steep where the clamps hold them level.
  CHECK(sags.back() > cable.catenary().sag());
  CHECK(sags.back() < 1.05 * cable.catenary().sag());
  check_close(sags[0], sags[2], {.relative = 1e-3});
  check_close(sags[1], sags[2], {.relative = 1e-3});
}
