// What every kind of chain must do, whichever unknowns its nodes have.
#include <doctest/doctest.h>

#include <numbers>

#include "math/dense.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/math/rotation.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Freedom;
using model::Unknown;
using strandyn::system::Matrix;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::busy_body;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::dense;
using strandyn::test::derivative;
using strandyn::test::for_every_freedom;
using strandyn::test::place;
using strandyn::test::RandomMotion;
using strandyn::test::SpanOptions;
using strandyn::test::zeros;

namespace {

SpanOptions short_span(Freedom freedom) {
  return {.length = 6, .elements = 6, .graded = false, .freedom = freedom};
}

/// Internal minus external force, and its tangent.
Vector balance(const System& system, const Vector& u) {
  Vector f = system.make_vector();
  Vector external = f;
  system.internal_force(u.data(), f.data());
  system.external_force({.time = 0.1}, u.data(), external.data());
  return f - external;
}

Eigen::MatrixXd stiffness(const System& system, const Vector& u) {
  Vector f = system.make_vector();
  Matrix K = system.make_matrix();
  system.internal_force(u.data(), f.data(), K);
  system.subtract_external_tangent({.time = 0.1}, u.data(), K);
  return dense(K);
}

/// Axial stiffness would hide the bending: x counts in units in which both are alike.
Vector units(const model::Model& model) {
  const auto c = conductor::section_constants(test::curlew());
  Vector units = zeros(model);
  for (std::size_t i = 0; i < model.unknowns(); ++i) {
    units(static_cast<Eigen::Index>(i)) = model.kind(i) == Unknown::x ? std::sqrt(c.EI_max / c.EA) : 1;
  }
  return units;
}

/// Largest error of the tangent, relative to its largest entry, in those units.
double tangent_error(const System& system, const Vector& u, double h) {
  const Vector unit = units(system.model());
  const Eigen::MatrixXd K = unit.asDiagonal() * stiffness(system, u) * unit.asDiagonal();
  Eigen::MatrixXd expected(u.size(), u.size());
  for (Eigen::Index j = 0; j < u.size(); ++j) {
    expected.col(j) = derivative(
        [&](double s) {
          return Vector(unit.cwiseProduct(balance(system, u + s * unit(j) * Vector::Unit(u.size(), j))));
        },
        h);
  }
  return (K - expected).lpNorm<Eigen::Infinity>() / K.lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("every chain: the tangent is the derivative of the force with moments that keep their direction") {
  for_every_freedom([](Freedom freedom) {
    model::Model model = curlew_span(test::stick_law(freedom), short_span(freedom));
    model.bodies = {busy_body(2)};
    model.loads = {{.node = 3, .force = {1, 2, 3}, .moment = {3e4, -5e4, 2e4}},
                   {.node = 4, .moment = {-2e4, 1e4, 4e4}, .history = model::Harmonic{.frequency = 2}, .dead = true}};
    System system(model);
    system.begin(zeros(model));
    RandomMotion random(1);
    for (const double size : {0.01, 0.5}) {
      CHECK(tangent_error(system, random(system, size), 1e-4) <= 1e-9);
    }
  });
}

TEST_CASE("every chain: the tangent is the derivative of the force while wires slip") {
  for_every_freedom([](Freedom freedom) {
    const model::Model model = curlew_span(test::return_map(freedom), short_span(freedom));
    System system(model);
    system.begin(zeros(model));
    RandomMotion random(6);
    double friction = 0;
    for (int i = 0; i < 3; ++i) friction += system.commit(random(system, 0.01).data()).friction;
    CHECK(friction > 0.01);
    CHECK(tangent_error(system, random(system, 0.01), 1e-7) <= 1e-6);
  });
}

TEST_CASE("every chain: internal forces are the gradient of the elastic energy, springs of bodies included") {
  for_every_freedom([](Freedom freedom) {
    model::Model model = curlew_span(test::stick_law(freedom), short_span(freedom));
    model.bodies = {busy_body(2), busy_body(4)};
    System system(model);
    system.begin(zeros(model));
    RandomMotion random(2);
    const Vector u = random(system, 0.1);
    const Vector f = balance(system, u);
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      // Energies of 1e6 J, lengths of 0.1 m: rounding leaves 1e-16 1e6/1e-4 of 1e7 N.
      const double slope = derivative(
          [&](double s) { return system.commit((u + s * Vector::Unit(u.size(), i)).eval().data()).elastic; }, 1e-4);
      check_close(f(i), slope, {.absolute = 1e-8 * f.lpNorm<Eigen::Infinity>()});
    }
  });
}

TEST_CASE("every chain: inertia and drag and dampers of bodies have their derivatives in the matrix") {
  for_every_freedom([](Freedom freedom) {
    for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
      SpanOptions options = short_span(freedom);
      options.mass = mass;
      options.rotary = 1e-4;
      options.drag = 0.3;
      model::Model model = curlew_span(test::stick_law(freedom), options);
      model.bodies = {busy_body(2)};
      System system(model);
      RandomMotion random(7);
      const Vector u = random(system, 0.3);
      const Vector v = random(system, 2);
      const Vector a = random(system, 50);
      const auto force = [&](const Vector& at, const Vector& rate, const Vector& acceleration) {
        Vector f = zeros(model);
        system.add_inertia_and_drag({.u = at.data(), .v = rate.data(), .a = acceleration.data()}, f.data());
        return f;
      };
      Matrix K = system.make_matrix();
      system.add_inertia_and_drag({.u = u.data(), .v = v.data(), .a = a.data()},
                                  {.acceleration = 3, .velocity = 0.7, .position = -2}, K);
      const Eigen::MatrixXd all = dense(K);
      for (Eigen::Index j = 0; j < u.size(); ++j) {
        const Vector unit = Vector::Unit(u.size(), j);
        const Vector expected =
            derivative([&](double s) { return force(u - 2 * s * unit, v + 0.7 * s * unit, a + 3 * s * unit); });
        CHECK((all.col(j) - expected).norm() <= 1e-10 * all.norm());
      }
    }
  });
}

TEST_CASE("every chain: kinetic energy is that of the mass matrix and of a span with its bodies in flight") {
  for_every_freedom([](Freedom freedom) {
    for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
      SpanOptions options = short_span(freedom);
      options.mass = mass;
      options.rotary = 1e-3;
      model::Model model = curlew_span(test::stick_law(freedom), options);
      model.bodies = {busy_body(2)};
      const System system(model);
      RandomMotion random(9);
      const Vector u = random(system, 0.3);
      Vector v = random(system, 2);
      Matrix M = system.make_matrix();
      system.mass_matrix(u.data(), M);
      check_close(system.kinetic_energy(u.data(), v.data()), 0.5 * v.dot(dense(M) * v), {.relative = 1e-13});
      v.setZero();
      for (std::size_t node = 0; node < model.nodes.size(); ++node) v(place(model, node, Unknown::y)) = 2;
      check_close(system.kinetic_energy(u.data(), v.data()), 2 * (test::curlew_mass * model.unstressed_length() + 3),
                  {.relative = 1e-13});
    }
  });
}

TEST_CASE("every chain: drag and dampers push against the velocity with the power that the ledger counts") {
  for_every_freedom([](Freedom freedom) {
    SpanOptions options = short_span(freedom);
    options.drag = 0.3;
    model::Model model = curlew_span(test::stick_law(freedom), options);
    model.bodies = {busy_body(2)};
    const System system(model);
    Vector v = zeros(model);
    const Vector rest = zeros(model);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) v(place(model, node, Unknown::y)) = 2;
    const double damper = 70 * std::pow(0.8 * 2, 2);
    check_close(system.viscous_power(v.data()).total(), 0.3 * 4 * model.unstressed_length() + damper,
                {.relative = 1e-13});
    RandomMotion random(8);
    v = random(system, 2);
    Vector f = zeros(model);
    system.add_inertia_and_drag({.u = rest.data(), .v = v.data(), .a = rest.data()}, f.data());
    check_close(f.dot(v), system.viscous_power(v.data()).total(), {.relative = 1e-13});
  });
}

TEST_CASE("every chain: supports hold what they say and prescribed motions are where their function is") {
  for_every_freedom([](Freedom freedom) {
    model::Model model = curlew_span(test::stick_law(freedom), short_span(freedom));
    model.motions = {{.node = 0, .unknown = Unknown::y, .amplitude = 0.02, .history = model::Harmonic{.frequency = 2}},
                     {.node = 3, .unknown = Unknown::rotation_z, .amplitude = -0.1},
                     {.node = 0, .unknown = Unknown::y, .amplitude = 0.5}};
    System system(model);
    CHECK(system.has_moving_supports());
    const auto moved = place(model, 0, Unknown::y);
    const auto turned = place(model, 3, Unknown::rotation_z);
    Vector u = Vector::Constant(zeros(model).size(), 9);
    system.held_values({.time = 1.0 / 24, .part = 0.5}, u.data());  // 30 degrees
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const std::size_t node = i / model.unknowns_per_node();
      CHECK(system.is_held(i) == (node == 0 || node == 6 || at == turned));
      if (system.is_held(i)) CHECK_FALSE(system.has_mass(i));
      if (!system.is_held(i)) CHECK(u(at) == 9);
      if (system.is_held(i) && at != moved && at != turned) CHECK(u(at) == 0);
    }
    check_close(u(moved), 0.5 * (0.02 * 0.5 + 0.5), {.relative = 1e-14});
    check_close(u(turned), -0.05, {.relative = 1e-14});
    Vector v = zeros(model);
    system.held_rates({.time = 0.3}, v.data());
    const Vector rates = derivative(
        [&](double s) {
          Vector at = zeros(model);
          system.held_values({.time = 0.3 + s}, at.data());
          return at;
        },
        1e-4);
    CHECK((v - rates).lpNorm<Eigen::Infinity>() <= 1e-11);
  });
}

TEST_CASE("every chain: a motion of an unknown that it does not have is refused") {
  model::Model model = curlew_span(test::stick_law(), short_span(Freedom::planar));
  model.motions = {{.node = 0, .unknown = Unknown::z, .amplitude = 1}};
  CHECK_THROWS_WITH_AS(System{model}, doctest::Contains("does not have"), ComputationError);
}

TEST_CASE("transverse chain: one tension rises with the mean square of the slope and couples all nodes") {
  for (const Freedom freedom : {Freedom::transverse_planar, Freedom::transverse_spatial}) {
    SpanOptions options = short_span(freedom);
    options.elements = 24;
    const model::Model model = curlew_span(test::stick_law(freedom), options);
    System system(model);
    Vector u = zeros(model);
    const double k = std::numbers::pi / 6;
    for (std::size_t node = 0; node <= 24; ++node) {
      const double x = model.nodes[node].x();
      u(place(model, node, Unknown::y)) = 0.05 * std::sin(k * x);
      u(place(model, node, Unknown::rotation_z)) = 0.05 * k * std::cos(k * x);
    }
    system.begin(u);
    // T = T_0 + EA/L_0 int w'^2/2 dx, the integral of the sine being (a k)^2 L/4.
    const double EA = conductor::section_constants(test::curlew()).EA;
    const double expected = test::curlew_tension + EA * std::pow(0.05 * k, 2) * 6 / 4 / model.unstressed_length();
    Vector f = zeros(model);
    Matrix K = system.make_matrix();
    system.internal_force(u.data(), f.data(), K);
    const section::Field& stresses = system.last_stresses();
    for (std::size_t point = 0; point < stresses.points(); ++point) {
      // The Hermite sine's error is of fourth order of 15 degrees an element.
      check_close(stresses[section::Component::axial][point], expected, {.relative = 1e-6});
    }
    const Eigen::MatrixXd full = dense(K);
    CHECK(std::abs(full(place(model, 1, Unknown::y), place(model, 23, Unknown::y))) > 1);
  }
}

TEST_CASE("spatial chain: a rotation told the other way round has the same energy and forces and motion") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    SpanOptions options = short_span(Freedom::spatial);
    options.mass = mass;
    options.rotary = 1e-3;
    model::Model model = curlew_span(test::stick_law(Freedom::spatial), options);
    model.supports.clear();
    System system(model);
    system.begin(zeros(model));
    RandomMotion random(3);
    // The whole span turned by 4.5 rad, and shaken.
    Vector u = random(system, 0.05);
    Vector v = random(system, 2);
    const Eigen::Vector3d turn = 4.5 * Eigen::Vector3d(1, 2, -2) / 3;
    const Eigen::Matrix3d R = math::rotation(turn);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      u.segment<3>(place(model, node, Unknown::x)) += R * model.nodes[node] - model.nodes[node];
      u.segment<3>(place(model, node, Unknown::rotation_x)) += turn;
    }
    const auto moments = [&](const Vector& f, const Vector& at, std::size_t node) -> Eigen::Vector3d {
      const auto i = place(model, node, Unknown::rotation_x);
      return math::spin_map(at.segment<3>(i)).transpose().partialPivLu().solve(Eigen::Vector3d(f.segment<3>(i)));
    };
    const Vector before = balance(system, u);
    const double kinetic = system.kinetic_energy(u.data(), v.data());
    const double elastic = system.commit(u.data()).elastic;
    const Vector long_way = u;
    REQUIRE(system.shorten_rotations(u.data(), v.data()));
    CHECK_FALSE(system.shorten_rotations(u.data(), v.data()));
    const Vector after = balance(system, u);
    check_close(system.kinetic_energy(u.data(), v.data()), kinetic, {.relative = 1e-12});
    check_close(system.commit(u.data()).elastic, elastic, {.relative = 1e-12});
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      const auto x = place(model, node, Unknown::x);
      CHECK(u.segment<3>(x) == long_way.segment<3>(x));
      CHECK(u.segment<3>(x + 3).norm() < 2);
      CHECK((after.segment<3>(x) - before.segment<3>(x)).norm() <= 1e-11 * before.norm());
      CHECK((moments(after, u, node) - moments(before, long_way, node)).norm() <= 1e-11 * before.norm());
    }
  }
}

TEST_CASE("spatial chain: nodes that are held in rotation keep their rotation vectors") {
  model::Model model = curlew_span(test::stick_law(Freedom::spatial), short_span(Freedom::spatial));
  model.supports[0].fixed[5] = false;
  System system(model);
  Vector u = zeros(model);
  Vector v = zeros(model);
  for (std::size_t node = 0; node < model.nodes.size(); ++node) u(place(model, node, Unknown::rotation_z)) = 4.2;
  CHECK(system.shorten_rotations(u.data(), v.data()));
  CHECK(u(place(model, 0, Unknown::rotation_z)) == 4.2);
  check_close(u(place(model, 1, Unknown::rotation_z)), 4.2 - 2 * std::numbers::pi, {.relative = 1e-13});
}

TEST_CASE("planar chain: rotations count turns and are never exchanged") {
  const model::Model model = curlew_span(test::stick_law(), short_span(Freedom::planar));
  const System system(model);
  Vector u = Vector::Constant(zeros(model).size(), 40);
  Vector v = u;
  CHECK_FALSE(system.shorten_rotations(u.data(), v.data()));
  CHECK(u.minCoeff() == 40);
}
