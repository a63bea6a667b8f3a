#include "strandyn/beam/rigid_inertia.hpp"

#include <doctest/doctest.h>

#include <random>

#include "strandyn/math/rotation.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"

using namespace strandyn::beam;
using strandyn::test::check_close;
using strandyn::test::derivative;

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  Eigen::Vector3d vector(double size) {
    return Eigen::Vector3d::NullaryExpr([&](Eigen::Index) { return between(-size, size); });
  }
  /// Up to 2.5 rad long.
  Eigen::Vector3d rotation() { return between(0, 2.5) * vector(1).normalized(); }
  RotationMotion motion() { return {.psi = rotation(), .rate = vector(2), .acceleration = vector(3)}; }
  /// Of three different principal moments of order 1 about any axes.
  RigidInertia body() {
    const Eigen::Matrix3d axes = strandyn::math::rotation(rotation());
    const Eigen::Vector3d principal(0.8, 1.3, 1.9);
    return {.mass = 2, .moment = axes * principal.asDiagonal() * axes.transpose()};
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::mt19937 random_;
};

double kinetic_energy(const RigidInertia& body, const Eigen::Vector3d& psi, const Eigen::Vector3d& rate) {
  return 0.5 * rate.dot(rotary_mass(body, psi) * rate);
}

/// The motion at a time t from one with constant acceleration.
RotationMotion after(const RotationMotion& m, double t) {
  return {.psi = m.psi + t * m.rate + t * t / 2 * m.acceleration,
          .rate = m.rate + t * m.acceleration,
          .acceleration = m.acceleration};
}

/// Rotations by the library's other way.
Eigen::Matrix3d turned_frame(const Eigen::Vector3d& psi) {
  return Eigen::AngleAxisd(psi.norm(), psi.normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("rigid inertia: the energy is that of the angular velocity seen from the body") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const RigidInertia body = random.body();
    const RotationMotion m = random.motion();
    const Eigen::Matrix3d R_t = derivative([&](double t) { return turned_frame(m.psi + t * m.rate); });
    const Eigen::Matrix3d W_cross = turned_frame(m.psi).transpose() * R_t;
    const Eigen::Vector3d W(W_cross(2, 1), W_cross(0, 2), W_cross(1, 0));
    // The differences leave some 1e-11.
    check_close(kinetic_energy(body, m.psi, m.rate), 0.5 * W.dot(body.moment * W), {.relative = 1e-9});
  }
}

TEST_CASE("rigid inertia: the mass matrix is symmetric and positive and at rest the moment itself") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const RigidInertia body = random.body();
    const Eigen::Matrix3d M = rotary_mass(body, random.rotation());
    CHECK((M - M.transpose()).lpNorm<Eigen::Infinity>() <= 2e-15);
    // The smallest moment times the least of |T v|^2/|v|^2, (2 sin(psi/2)/psi)^2 = 0.57 at 2.5 rad.
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(M).eigenvalues().minCoeff() > 0.8 * 0.57);
    CHECK(rotary_mass(body, Eigen::Vector3d::Zero()) == body.moment);
  }
}

TEST_CASE("rigid inertia: kinetic energy does not know how space is turned") {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const RigidInertia body = random.body();
    const RotationMotion m = random.motion();
    const Eigen::Matrix3d Q = strandyn::math::rotation(random.rotation());
    const Eigen::Vector3d psi = strandyn::math::rotation_vector(Q * strandyn::math::rotation(m.psi));
    const Eigen::Vector3d spin = Q * strandyn::math::spin_map(m.psi) * m.rate;
    const double there = kinetic_energy(body, psi, strandyn::math::inverse_spin_map(psi) * spin);
    check_close(there, kinetic_energy(body, m.psi, m.rate), {.relative = 1e-14});
  }
}

TEST_CASE("rigid inertia: the force is Lagrange's of the kinetic energy") {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const RigidInertia body = random.body();
    const RotationMotion m = random.motion();
    Eigen::Vector3d expected = derivative([&](double t) -> Eigen::Vector3d {
      const RotationMotion at = after(m, t);
      return rotary_mass(body, at.psi) * at.rate;
    });
    for (int j = 0; j < 3; ++j) {
      expected(j) -=
          derivative([&](double s) { return kinetic_energy(body, m.psi + s * Eigen::Vector3d::Unit(j), m.rate); });
    }
    CHECK((rotary_force(body, m) - expected).norm() <= 1e-10 * expected.norm());
  }
}

TEST_CASE("rigid inertia: its tangents are the derivatives of the force at any angle and at none") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const RigidInertia body = random.body();
    RotationMotion m = random.motion();
    if (i == 0) m.psi.setZero();
    const RotaryTangent t = rotary_tangent(body, m);
    const double scale = t.mass.norm() + t.velocity.norm() + t.position.norm();
    for (int j = 0; j < 3; ++j) {
      const auto along = [&](Eigen::Vector3d RotationMotion::*part) -> Eigen::Vector3d {
        return derivative([&](double s) {
          RotationMotion moved = m;
          (moved.*part)(j) += s;
          return rotary_force(body, moved);
        });
      };
      CHECK((t.mass.col(j) - along(&RotationMotion::acceleration)).norm() <= 1e-11 * scale);
      CHECK((t.velocity.col(j) - along(&RotationMotion::rate)).norm() <= 1e-11 * scale);
      CHECK((t.position.col(j) - along(&RotationMotion::psi)).norm() <= 1e-11 * scale);
    }
    CHECK((t.mass - rotary_mass(body, m.psi)).norm() <= 1e-15 * scale);
  }
}

TEST_CASE("rigid inertia: about a fixed principal axis the force is moment times angular acceleration") {
  const RigidInertia body{.mass = 1, .moment = Eigen::Vector3d(0.8, 1.3, 1.9).asDiagonal()};
  for (const double angle : {-2.4, 0.0, 1e-9, 1.1, 3.1}) {
    const RotationMotion m{.psi = {0, 0, angle}, .rate = {0, 0, 5}, .acceleration = {0, 0, -3}};
    // The terms with rate^2 cancel between c_0 and c_3: rounding of 25.
    CHECK((rotary_force(body, m) - Eigen::Vector3d(0, 0, -3 * 1.9)).norm() <= 25 * 1.9 * 1e-15);
  }
}

TEST_CASE("rigid inertia: a tiny rotation loses no digits") {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const RigidInertia body = random.body();
    const RotationMotion still{
        .psi = Eigen::Vector3d::Zero(), .rate = random.vector(2), .acceleration = random.vector(3)};
    RotationMotion turned = still;
    turned.psi = 1e-9 * random.vector(1);
    // What is left out is of second order, 1e-18.
    const Eigen::Vector3d expected = rotary_force(body, still) + rotary_tangent(body, still).position * turned.psi;
    CHECK((rotary_force(body, turned) - expected).norm() <= 1e-15 * expected.norm());
    // All of it tiny: J psi'' but for products.
    const RotationMotion faint{.psi = turned.psi, .rate = 1e-9 * still.rate, .acceleration = 1e-9 * still.acceleration};
    const Eigen::Vector3d linear = body.moment * faint.acceleration;
    CHECK((rotary_force(body, faint) - linear).norm() <= 1e-8 * linear.norm());
  }
}

TEST_CASE("rigid inertia: a body free of torque keeps its energy and its angular momentum in space") {
  const RigidInertia body{.mass = 1, .moment = Eigen::Vector3d(0.8, 1.3, 1.9).asDiagonal()};
  struct State {
    Eigen::Vector3d psi, rate;
  };
  const auto momentum = [&](const State& s) -> Eigen::Vector3d {
    const Eigen::Matrix3d R = strandyn::math::rotation(s.psi);
    return R * body.moment * R.transpose() * strandyn::math::spin_map(s.psi) * s.rate;
  };
  const auto energy = [&](const State& s) { return kinetic_energy(body, s.psi, s.rate); };
  const auto rate_of = [&](const State& s) -> State {
    const RotationMotion coasting{.psi = s.psi, .rate = s.rate, .acceleration = Eigen::Vector3d::Zero()};
    return {.psi = s.rate, .rate = -rotary_mass(body, s.psi).inverse() * rotary_force(body, coasting)};
  };
  const auto moved = [](const State& s, double h, const State& by) -> State {
    return {.psi = s.psi + h * by.psi, .rate = s.rate + h * by.rate};
  };

  // About the intermediate axis, so that it tumbles, from one side of zero to the other.
  State s{.psi = {0.3, -2.0, 0.2}, .rate = {0.3, 2, 0.4}};
  const double energy_at_start = energy(s);
  const Eigen::Vector3d momentum_at_start = momentum(s);
  const Eigen::Vector3d spin_at_start = strandyn::math::spin_map(s.psi) * s.rate;
  constexpr double h = 2e-3;
  for (int step = 0; step < 1000; ++step) {
    const State k1 = rate_of(s);
    const State k2 = rate_of(moved(s, h / 2, k1));
    const State k3 = rate_of(moved(s, h / 2, k2));
    const State k4 = rate_of(moved(s, h, k3));
    s = moved(moved(moved(moved(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  // The method's own error, of fourth order: measured 3e-13.
  check_close(energy(s), energy_at_start, {.relative = 1e-11});
  CHECK((momentum(s) - momentum_at_start).norm() <= 1e-11 * momentum_at_start.norm());
  CHECK((strandyn::math::spin_map(s.psi) * s.rate - spin_at_start).norm() > 0.3);
}
