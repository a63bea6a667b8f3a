#include "strandyn/system/system.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "math/dense.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::system::Matrix;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::dense;
using strandyn::test::derivative;
using strandyn::test::RandomMotion;
using strandyn::test::SpanOptions;
using strandyn::test::zeros;

namespace {

/// Ten like elements over 6 m: deflections and rotations of a hundredth bend them beyond chi_0 and leave the tension
/// within half of its own size.
constexpr SpanOptions short_span{.length = 6, .elements = 10, .graded = false};
constexpr double slipping = 0.01;  // [m], [rad]

Vector force_at(const System& system, const Vector& u) {
  Vector f(u.size());
  system.internal_force(u.data(), f.data());
  return f;
}

/// Moves a system along a path on which wires slip to and fro.
void shake(System& system, RandomMotion& random, int steps) {
  for (int i = 0; i < steps; ++i) {
    const Vector u = random(system, slipping);
    system.commit(u.data());
  }
}

/// N and M of all points by the law itself, with a history of its own: the other way.
struct OwnSections {
  const section::Law& law;
  section::History history;
  section::Field strains, stresses;

  OwnSections(const System& system)
      : law(*system.model().law),
        history(law.start(system.committed_strains())),
        strains(system.committed_strains()),
        stresses(strains) {
    law.respond(history, strains, stresses, nullptr);
  }

  /// Trapezoidal work [J] of the resultants on the way to the strains committed last.
  double work_to(const System& system) {
    const section::Field before = strains;
    const section::Field force_before = stresses;
    strains = system.committed_strains();
    law.respond(history, strains, stresses, nullptr);
    double sum = 0;
    for (const section::Component c : {section::Component::axial, section::Component::bending2}) {
      for (std::size_t i = 0; i < strains.points(); ++i) {
        sum += system.point_length(i) * 0.5 * (stresses[c][i] + force_before[c][i]) * (strains[c][i] - before[c][i]);
      }
    }
    section::StepEnergy unused(strains.points());
    law.commit(history, strains, unused);
    return sum;
  }
};

}  // namespace

TEST_CASE("system: states that are tried and thrown away leave no trace in what is committed") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System tried(model);
  System untouched(model);
  tried.begin(zeros(model));
  untouched.begin(zeros(model));
  RandomMotion path(1);
  RandomMotion trials(2);
  double friction = 0;
  for (int i = 0; i < 10; ++i) {
    const Vector u = path(tried, slipping);
    Matrix K = tried.make_matrix();
    Vector f = zeros(model);
    for (int k = 0; k < 5; ++k) tried.internal_force(trials(tried, 2 * slipping).data(), f.data(), K);
    const system::Accepted a = tried.commit(u.data());
    const system::Accepted b = untouched.commit(u.data());
    CHECK(a.elastic == b.elastic);
    CHECK(a.friction == b.friction);
    CHECK(a.quadrature_error == b.quadrature_error);
    CHECK(force_at(tried, u) == force_at(untouched, u));
    friction += a.friction;
  }
  CHECK(friction > 0.1);  // [J] wires did slip
}

TEST_CASE("system: committing a state does not change the force there") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System system(model);
  system.begin(zeros(model));
  RandomMotion random(3);
  for (int i = 0; i < 10; ++i) {
    const Vector u = random(system, slipping);
    const Vector before = force_at(system, u);
    system.commit(u.data());
    // So the integrator can go on from there without a new start.
    CHECK((force_at(system, u) - before).lpNorm<Eigen::Infinity>() <= 1e-13 * before.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("system: stored and dissipated energy of a step make up the trapezoidal work of the sections") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System system(model);
  system.begin(zeros(model));
  double elastic = system.commit(zeros(model).data()).elastic;
  OwnSections sections(system);
  RandomMotion random(4);
  for (int i = 0; i < 20; ++i) {
    const Vector u = random(system, slipping);
    const system::Accepted step = system.commit(u.data());
    const double work = sections.work_to(system);
    CHECK(step.friction > 0);
    CHECK(step.quadrature_error >= 0);
    check_close(step.elastic - elastic + step.friction - step.quadrature_error, work,
                {.absolute = 1e-13 * (step.elastic + elastic + step.friction)});
    elastic = step.elastic;
  }
}

TEST_CASE("system: the elastic energy of the tensioned span is T^2 L/(2 EA)") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System system(model);
  system.begin(zeros(model));
  const double EA = conductor::section_constants(test::curlew()).EA;
  const double expected = test::curlew_tension * test::curlew_tension * model.unstressed_length() / (2 * EA);
  // Counted from the begin: nothing, and what is given back when the tension is taken off.
  CHECK(system.commit(zeros(model).data()).elastic == 0.0);
  Vector slack = zeros(model);
  double back = 0;
  for (std::size_t node = 1; node < model.nodes.size(); ++node) {
    back += model.elements[node - 1].span.norm() - model.elements[node - 1].length;
    slack(static_cast<Eigen::Index>(*model.index(node, model::Unknown::x))) = -back;
  }
  const system::Accepted loose = system.commit(slack.data());
  check_close(loose.elastic, -expected, {.relative = 1e-12});
  CHECK(loose.friction == 0.0);
  const Vector f = force_at(system, zeros(model));
  check_close(-f(0), test::curlew_tension, {.relative = 1e-12});
  CHECK(f.segment(3, f.size() - 6).lpNorm<Eigen::Infinity>() <= 1e-10 * test::curlew_tension);
}

TEST_CASE("system: the force on the nodes is the gradient of the elastic energy") {
  const model::Model model = curlew_span(test::stick_law(), short_span);
  System system(model);
  RandomMotion random(5);
  system.begin(zeros(model));
  const Vector u = random(system, slipping);
  const Vector f = force_at(system, u);
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    // Energies of 1e4 J, lengths of 1e-2 m over which they vary: rounding leaves 1e-16 1e4/1e-4 of 1e6 N.
    const double slope = derivative(
        [&](double s) {
          Vector moved = u;
          moved(i) += s;
          return system.commit(moved.data()).elastic;
        },
        1e-4);
    check_close(f(i), slope, {.absolute = 1e-9 * f.lpNorm<Eigen::Infinity>()});
  }
}

TEST_CASE("system: the tangent is the derivative of the force while wires slip") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System system(model);
  system.begin(zeros(model));
  RandomMotion random(6);
  shake(system, random, 5);
  // Well inside a step on which wires slip: no kink within the reach of the differences.
  const Vector u = random(system, slipping);
  Matrix K = system.make_matrix();
  Vector f = zeros(model);
  system.internal_force(u.data(), f.data(), K);
  CHECK(f == force_at(system, u));
  // Axial stiffness would hide the bending: x counts in units in which both are alike.
  const auto c = conductor::section_constants(test::curlew());
  const Vector units = Eigen::Vector3d(std::sqrt(c.EI_max / c.EA), 1, 1).replicate(f.size() / 3, 1);
  Eigen::MatrixXd expected(f.size(), f.size());
  for (Eigen::Index j = 0; j < u.size(); ++j) {
    expected.col(j) = derivative(
        [&](double s) {
          Vector moved = u;
          moved(j) += s * units(j);
          return Vector(units.cwiseProduct(force_at(system, moved)));
        },
        1e-6);
  }
  const Eigen::MatrixXd tangent = units.asDiagonal() * dense(K) * units.asDiagonal();
  CHECK((tangent - expected).lpNorm<Eigen::Infinity>() <= 1e-8 * tangent.lpNorm<Eigen::Infinity>());
  // It is not that of a sticking span, and not symmetric, since the limits follow the tension.
  CHECK((tangent - tangent.transpose()).lpNorm<Eigen::Infinity>() > 1e-4 * tangent.lpNorm<Eigen::Infinity>());
}

TEST_CASE("system: inertia and drag have their derivatives in the matrix") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    SpanOptions options = short_span;
    options.mass = mass;
    options.rotary = 1e-4;
    options.drag = 0.3;
    const model::Model model = curlew_span(test::stick_law(), options);
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
    const auto matrix = [&](system::InertiaFactors factors) {
      Matrix K = system.make_matrix();
      system.add_inertia_and_drag({.u = u.data(), .v = v.data(), .a = a.data()}, factors, K);
      return dense(K);
    };
    const Eigen::MatrixXd all = matrix({.acceleration = 3, .velocity = 0.7, .position = -2});
    for (Eigen::Index j = 0; j < u.size(); ++j) {
      const Vector unit = Vector::Unit(u.size(), j);
      const Vector expected =
          derivative([&](double s) { return force(u - 2 * s * unit, v + 0.7 * s * unit, a + 3 * s * unit); });
      CHECK((all.col(j) - expected).norm() <= 1e-10 * all.norm());
    }
  }
}

TEST_CASE("system: held unknowns and those without mass are told apart") {
  const auto with_mass = [](SpanOptions options) {
    const model::Model model = curlew_span(test::stick_law(), options);
    const System system(model);
    CHECK(system.is_held(0));
    CHECK(system.is_held(1));
    CHECK(system.is_held(2) == options.clamped);
    CHECK_FALSE(system.has_mass(0));
    CHECK_FALSE(system.is_held(5));
    CHECK(system.has_mass(3));
    CHECK(system.has_mass(4));
    return system.has_mass(5);  // the rotation of a free node
  };
  CHECK_FALSE(with_mass({.elements = 3}));
  CHECK_FALSE(with_mass({.elements = 3, .clamped = false}));
  CHECK(with_mass({.elements = 3, .rotary = 1e-4}));
  CHECK(with_mass({.elements = 3, .mass = model::MassMatrix::consistent}));
}

TEST_CASE("system: the equation of a held unknown reads as its right side and all others stay as they are") {
  const model::Model model = curlew_span(test::stick_law(), short_span);
  System system(model);
  system.begin(zeros(model));
  Matrix K = system.make_matrix();
  Vector f = zeros(model);
  system.internal_force(zeros(model).data(), f.data(), K);
  // The columns stay too: what a support moves by loads its neighbours.
  Eigen::MatrixXd expected = dense(K);
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (system.is_held(i)) expected.row(at) = Vector::Unit(f.size(), at).transpose();
  }
  system.hold(K);
  CHECK(dense(K) == expected);
}

TEST_CASE("system: drag takes c v^2 per length and pushes against the velocity") {
  SpanOptions options = short_span;
  options.drag = 0.3;
  const model::Model model = curlew_span(test::stick_law(), options);
  const System system(model);
  Vector v = zeros(model);
  for (Eigen::Index i = 1; i < v.size(); i += 3) v(i) = 2;
  check_close(system.viscous_power(v.data()).total(), 0.3 * 4 * model.unstressed_length(), {.relative = 1e-13});

  RandomMotion random(8);
  v = random(system, 2);
  Vector f = zeros(model);
  const Vector rest = zeros(model);
  system.add_inertia_and_drag({.u = rest.data(), .v = v.data(), .a = rest.data()}, f.data());
  check_close(f.dot(v), system.viscous_power(v.data()).total(), {.relative = 1e-13});
}

TEST_CASE("system: kinetic energy is that of the mass matrix and of a whole span in flight") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    SpanOptions options = short_span;
    options.mass = mass;
    const model::Model model = curlew_span(test::stick_law(), options);
    const System system(model);
    RandomMotion random(9);
    const Vector u = random(system, 0.3);
    Vector v = random(system, 2);
    Matrix M = system.make_matrix();
    system.mass_matrix(u.data(), M);
    check_close(system.kinetic_energy(u.data(), v.data()), 0.5 * v.dot(dense(M) * v), {.relative = 1e-13});
    v.setZero();
    for (Eigen::Index i = 0; i < v.size(); i += 3) v(i) = 2;
    check_close(system.kinetic_energy(u.data(), v.data()), 2 * test::curlew_mass * model.unstressed_length(),
                {.relative = 1e-13});
  }
}

TEST_CASE("system: accelerations balance the forces on every unknown with mass") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    SpanOptions options = short_span;
    options.mass = mass;
    options.drag = 0.3;
    const model::Model model = curlew_span(test::stick_law(), options);
    const System system(model);
    RandomMotion random(10);
    const Vector u = random(system, 0.3);
    const Vector v = random(system, 2);
    const Vector force = random(system, 100);
    Vector a = zeros(model);
    system.accelerations(u.data(), v.data(), force.data(), a.data());
    Vector balance = -force;
    system.add_inertia_and_drag({.u = u.data(), .v = v.data(), .a = a.data()}, balance.data());
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (system.has_mass(i)) {
        CHECK(std::abs(balance(at)) <= 1e-11 * force.norm());
      } else {
        CHECK(a(at) == 0.0);
      }
    }
  }
}

TEST_CASE("system: loads act on their nodes and follow their own histories") {
  model::Model model = curlew_span(test::stick_law(), short_span);
  model.loads = {{.node = 4, .force = {1, 20, 0}, .history = model::Harmonic{.frequency = 2}},
                 {.node = 4, .force = {0, 5, 0}, .history = model::Constant{}},
                 {.node = 7, .moment = {0, 0, 3}, .history = model::Constant{}}};
  const System system(model);
  Vector f = zeros(model);
  system.external_force({.time = 1.0 / 24}, zeros(model).data(), f.data());  // 30 degrees
  Vector expected = zeros(model);
  expected(12) = 0.5;
  expected(13) = 15;
  expected(23) = 3;
  CHECK((f - expected).lpNorm<Eigen::Infinity>() <= 1e-14);
}

TEST_CASE("system: its counters tell residuals, tangents and section points") {
  const model::Model model = curlew_span(test::return_map(), short_span);
  System system(model);
  system.begin(zeros(model));
  const auto before = system.effort();
  Matrix K = system.make_matrix();
  Vector f = zeros(model);
  system.internal_force(zeros(model).data(), f.data());
  system.internal_force(zeros(model).data(), f.data(), K);
  CHECK(system.residual_evaluations() == 1);
  CHECK(system.jacobian_evaluations() == 1);
  CHECK(system.effort().evaluations - before.evaluations == 2 * 20);
}
