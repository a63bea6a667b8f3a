#include "strandyn/beam/planar_inertia.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "beam/states.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"

using namespace strandyn::beam;
using strandyn::test::check_close;
using strandyn::test::derivative;
using strandyn::test::moved_rigidly;
using strandyn::test::RandomBeam;

namespace {

constexpr Inertia inertia{.mass = 2, .rotary = 0.3};

double kinetic_energy(const PlanarElement& element, const PlanarVector& q, const PlanarVector& v) {
  return 0.5 * v.dot(consistent_mass(element, inertia, q) * v);
}

PlanarMotion random_motion(RandomBeam& random, const PlanarElement& element) {
  return {.q = random.position(element), .v = random.vector(2), .a = random.vector(3)};
}

/// The motion at a time t from one with constant acceleration.
PlanarMotion after(const PlanarMotion& m, double t) {
  return {.q = m.q + t * m.v + t * t / 2 * m.a, .v = m.v + t * m.a, .a = m.a};
}

PlanarElement straight(double length) {
  return {.span = {length, 0}, .length = length, .rest_angle = 0};
}

}  // namespace

TEST_CASE("planar inertia: lumped and consistent masses carry the whole mass in both directions") {
  RandomBeam random(1);
  const PlanarElement element = random.element();
  const PlanarMatrix consistent = consistent_mass(element, inertia, random.position(element));
  const PlanarMatrix lumped = lumped_mass(element, inertia).asDiagonal();
  for (const PlanarMatrix& M : {consistent, lumped}) {
    for (const int direction : {0, 1}) {
      const PlanarVector v = PlanarVector::Unit(direction) + PlanarVector::Unit(direction + 3);
      check_close(v.dot(M * v), inertia.mass * element.length, {.relative = 1e-14});
    }
    const PlanarVector turn = PlanarVector::Unit(2) + PlanarVector::Unit(5);
    CHECK(turn.dot(M * turn) >= inertia.rotary * element.length);
  }
  check_close(lumped(2, 2) + lumped(5, 5), inertia.rotary * element.length, {.relative = 1e-14});
}

TEST_CASE("planar inertia: the consistent mass matrix is symmetric and positive") {
  RandomBeam random(2);
  for (int i = 0; i < 20; ++i) {
    const PlanarElement element = random.element();
    const PlanarMatrix M = consistent_mass(element, {.mass = 2, .rotary = 0}, random.position(element));
    CHECK((M - M.transpose()).lpNorm<Eigen::Infinity>() <= 1e-15);
    const auto eigen = Eigen::SelfAdjointEigenSolver<PlanarMatrix>(M, Eigen::EigenvaluesOnly).eigenvalues();
    // The smallest belongs to nodal turns against each other, m l^3/420 and the like.
    CHECK(eigen.minCoeff() > 1e-3);
  }
}

TEST_CASE("planar inertia: a straight rod that spins about its middle has m l^2/12 and the sections' own") {
  const double length = 1.7;
  const PlanarElement element = straight(length);
  PlanarVector v = PlanarVector::Zero();
  v(1) = -length / 2;
  v(4) = length / 2;
  v(2) = v(5) = 1;
  const double expected = inertia.mass * std::pow(length, 3) / 12 + inertia.rotary * length;
  check_close(2 * kinetic_energy(element, PlanarVector::Zero(), v), expected, {.relative = 1e-14});
}

TEST_CASE("planar inertia: kinetic energy does not know where the element lies or how it is turned") {
  RandomBeam random(3);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarVector q = random.vector(0.3);
    const PlanarVector v = random.vector(2);
    const double angle = random.between(-60, 60);
    PlanarVector turned_v = v;
    for (const int node : {0, 3}) turned_v.segment<2>(node) = strandyn::test::turned(v.segment<2>(node), angle);
    const double there = kinetic_energy(element, moved_rigidly(element, q, angle, {3, -1}), turned_v);
    check_close(there, kinetic_energy(element, q, v), {.relative = 1e-14});
  }
}

TEST_CASE("planar inertia: the force is Lagrange's of the kinetic energy") {
  RandomBeam random(4);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarMotion m = random_motion(random, element);
    PlanarVector expected = derivative([&](double t) -> PlanarVector {
      const PlanarMotion at = after(m, t);
      return consistent_mass(element, inertia, at.q) * at.v;
    });
    for (int j = 0; j < 6; ++j) {
      expected(j) -=
          derivative([&](double s) { return kinetic_energy(element, m.q + s * PlanarVector::Unit(j), m.v); });
    }
    const PlanarVector force = consistent_inertia_force(element, inertia, m);
    CHECK((force - expected).lpNorm<Eigen::Infinity>() <= 1e-10 * expected.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("planar inertia: the power of the force is the rate of the kinetic energy") {
  RandomBeam random(5);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarMotion m = random_motion(random, element);
    const double rate = derivative([&](double t) {
      const PlanarMotion at = after(m, t);
      return kinetic_energy(element, at.q, at.v);
    });
    const PlanarVector force = consistent_inertia_force(element, inertia, m);
    check_close(m.v.dot(force), rate, {.absolute = 1e-10 * m.v.norm() * force.norm()});
  }
}

TEST_CASE("planar inertia: its tangents are the derivatives of the force") {
  RandomBeam random(6);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarMotion m = random_motion(random, element);
    struct {
      PlanarMatrix mass, velocity, position;
    } const t{.mass = consistent_inertia_tangent(element, inertia, m, {.acceleration = 1}),
              .velocity = consistent_inertia_tangent(element, inertia, m, {.velocity = 1}),
              .position = consistent_inertia_tangent(element, inertia, m, {.position = 1})};
    for (int j = 0; j < 6; ++j) {
      const auto along = [&](auto&& change) {
        return derivative([&](double s) {
          PlanarMotion moved = m;
          change(moved)(j) += s;
          return consistent_inertia_force(element, inertia, moved);
        });
      };
      const PlanarVector by_a = along([](PlanarMotion& x) -> PlanarVector& { return x.a; });
      const PlanarVector by_v = along([](PlanarMotion& x) -> PlanarVector& { return x.v; });
      const PlanarVector by_q = along([](PlanarMotion& x) -> PlanarVector& { return x.q; });
      const double scale = t.mass.norm() + t.velocity.norm() + t.position.norm();
      CHECK((t.mass.col(j) - by_a).norm() <= 1e-11 * scale);
      CHECK((t.velocity.col(j) - by_v).norm() <= 1e-11 * scale);
      CHECK((t.position.col(j) - by_q).norm() <= 1e-11 * scale);
    }
    CHECK(t.mass == consistent_mass(element, inertia, m.q));
    const PlanarMatrix sum =
        consistent_inertia_tangent(element, inertia, m, {.acceleration = 3, .velocity = -2, .position = 0.5});
    CHECK((sum - (3 * t.mass - 2 * t.velocity + 0.5 * t.position)).norm() <= 1e-14 * sum.norm());
    check_close(strandyn::beam::kinetic_energy(element, inertia, m.q, m.v), m.v.dot(t.mass * m.v) / 2,
                {.relative = 1e-13});
  }
}
