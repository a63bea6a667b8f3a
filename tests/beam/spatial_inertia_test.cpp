#include "strandyn/beam/spatial_inertia.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "strandyn/beam/planar_inertia.hpp"
#include "strandyn/math/rotation.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"

using namespace strandyn::beam;
using strandyn::test::check_close;
using strandyn::test::derivative;

namespace {

constexpr double mass = 2;  // [kg/m]
constexpr SpatialSectionInertia of_section{.mass = mass, .rotary = 0, .polar = 0.7};

/// Elements and motions of order 1 in every unit.
class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  template <class Vector>
  Vector vector(double size) {
    return Vector::NullaryExpr([&](Eigen::Index) { return between(-size, size); });
  }
  /// Up to 2.5 rad long.
  Eigen::Vector3d rotation() { return between(0, 2.5) * vector<Eigen::Vector3d>(1).normalized(); }
  SpatialElement element() {
    const Eigen::Matrix3d triad = strandyn::math::rotation(rotation());
    return {.span = 1.3 * triad.col(0), .length = between(1.2, 1.3), .triad = triad};
  }
  SpatialVector position() {
    SpatialVector q;
    q << vector<Eigen::Vector3d>(1), rotation(), vector<Eigen::Vector3d>(1), rotation();
    return q;
  }
  SpatialMotion motion() { return {.q = position(), .v = vector<SpatialVector>(2), .a = vector<SpatialVector>(3)}; }

 private:
  std::mt19937 random_;
};

double kinetic_energy(const SpatialElement& element, const SpatialVector& q, const SpatialVector& v) {
  return 0.5 * v.dot(consistent_mass(element, of_section, q) * v);
}

/// The motion at a time t from one with constant acceleration.
SpatialMotion after(const SpatialMotion& m, double t) {
  return {.q = m.q + t * m.v + t * t / 2 * m.a, .v = m.v + t * m.a, .a = m.a};
}

/// Unknowns of the planar element and where they are among the spatial ones: a motion in the x-y plane.
constexpr std::array<int, 6> in_plane = {0, 1, 5, 6, 7, 11};

SpatialVector lifted(const PlanarVector& planar) {
  SpatialVector spatial = SpatialVector::Zero();
  for (int i = 0; i < 6; ++i) spatial(in_plane[static_cast<std::size_t>(i)]) = planar(i);
  return spatial;
}

/// The largest difference between a spatial matrix in the plane and a planar one.
double planar_difference(const SpatialMatrix& spatial, const PlanarMatrix& planar) {
  return (spatial(in_plane, in_plane) - planar).lpNorm<Eigen::Infinity>();
}

}  // namespace

TEST_CASE("spatial inertia: an element that moves without turning has its mass in every direction") {
  Random random(1);
  const SpatialElement element = random.element();
  const SpatialMatrix M = consistent_mass(element, of_section, random.position());
  for (const int direction : {0, 1, 2}) {
    const SpatialVector v = SpatialVector::Unit(direction) + SpatialVector::Unit(direction + 6);
    check_close(v.dot(M * v), mass * element.length, {.relative = 1e-14});
  }
}

TEST_CASE("spatial inertia: a straight rod that spins about its middle has m l^2/12 across and nothing along itself") {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const SpatialElement element = random.element();
    const Eigen::Matrix3d& triad = element.triad;
    const Eigen::Vector3d turn = random.rotation();  // of the whole rod
    const Eigen::Matrix3d Q = strandyn::math::rotation(turn);
    const Eigen::Vector3d half = element.length / 2 * Q * triad.col(0);
    SpatialVector q = SpatialVector::Zero();
    q.segment<3>(3) = q.segment<3>(9) = turn;
    const auto energy = [&](const Eigen::Vector3d& spin) {
      const Eigen::Vector3d rate = strandyn::math::inverse_spin_map(turn) * spin;
      SpatialVector v;
      v << -spin.cross(half), rate, spin.cross(half), rate;
      return kinetic_energy(element, q, v);
    };
    for (const int across : {1, 2}) {
      check_close(2 * energy(Q * triad.col(across)), mass * std::pow(element.length, 3) / 12, {.relative = 1e-13});
    }
    check_close(energy(Q * triad.col(0)), 0, {.relative = 0, .absolute = 1e-16});  // measured 2e-18
  }
}

TEST_CASE("spatial inertia: kinetic energy does not know where the element lies or how it is turned") {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialVector q = random.position();
    const auto v = random.vector<SpatialVector>(2);
    const Eigen::Matrix3d Q = strandyn::math::rotation(random.rotation());
    SpatialVector turned_q = q, turned_v = v;
    for (const int node : {0, 6}) {
      const Eigen::Vector3d psi = q.segment<3>(node + 3);
      const Eigen::Vector3d turned = strandyn::math::rotation_vector(Q * strandyn::math::rotation(psi));
      turned_q.segment<3>(node + 3) = turned;
      turned_v.segment<3>(node) = Q * v.segment<3>(node);
      turned_v.segment<3>(node + 3) =
          strandyn::math::inverse_spin_map(turned) * Q * strandyn::math::spin_map(psi) * v.segment<3>(node + 3);
    }
    check_close(kinetic_energy(element, turned_q, turned_v), kinetic_energy(element, q, v), {.relative = 1e-14});
  }
}

TEST_CASE("spatial inertia: the force is Lagrange's of the kinetic energy") {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialMotion m = random.motion();
    SpatialVector expected = derivative([&](double t) -> SpatialVector {
      const SpatialMotion at = after(m, t);
      return consistent_mass(element, of_section, at.q) * at.v;
    });
    for (int j = 0; j < 12; ++j) {
      expected(j) -=
          derivative([&](double s) { return kinetic_energy(element, m.q + s * SpatialVector::Unit(j), m.v); });
    }
    const SpatialVector force = consistent_inertia_force(element, of_section, m);
    CHECK((force - expected).norm() <= 1e-10 * expected.norm());
  }
}

TEST_CASE("spatial inertia: the power of the force is the rate of the kinetic energy") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialMotion m = random.motion();
    const double rate = derivative([&](double t) {
      const SpatialMotion at = after(m, t);
      return kinetic_energy(element, at.q, at.v);
    });
    const SpatialVector force = consistent_inertia_force(element, of_section, m);
    check_close(m.v.dot(force), rate, {.relative = 0, .absolute = 1e-10 * m.v.norm() * force.norm()});
  }
}

struct Tangents {
  SpatialMatrix mass, velocity, position;
};

Tangents tangents(const SpatialElement& element, const SpatialMotion& m) {
  return {.mass = consistent_inertia_tangent(element, of_section, m, {.acceleration = 1}),
          .velocity = consistent_inertia_tangent(element, of_section, m, {.velocity = 1}),
          .position = consistent_inertia_tangent(element, of_section, m, {.position = 1})};
}

TEST_CASE("spatial inertia: its tangents are the derivatives of the force at any angle and at none") {
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    SpatialMotion m = random.motion();
    if (i == 0) m.q.setZero();
    const Tangents t = tangents(element, m);
    const double scale = t.mass.norm() + t.velocity.norm() + t.position.norm();
    for (int j = 0; j < 12; ++j) {
      const auto along = [&](SpatialVector SpatialMotion::*part) -> SpatialVector {
        return derivative([&](double s) {
          SpatialMotion moved = m;
          (moved.*part)(j) += s;
          return consistent_inertia_force(element, of_section, moved);
        });
      };
      CHECK((t.mass.col(j) - along(&SpatialMotion::a)).norm() <= 1e-11 * scale);
      CHECK((t.velocity.col(j) - along(&SpatialMotion::v)).norm() <= 1e-11 * scale);
      CHECK((t.position.col(j) - along(&SpatialMotion::q)).norm() <= 1e-11 * scale);
    }
    CHECK((t.mass - consistent_mass(element, of_section, m.q)).norm() <= 1e-15 * scale);
    CHECK((t.mass - t.mass.transpose()).norm() <= 1e-15 * scale);
    const SpatialMatrix sum = 3 * t.mass - 2 * t.velocity + 0.5 * t.position;
    const SpatialMatrix at_once =
        consistent_inertia_tangent(element, of_section, m, {.acceleration = 3, .velocity = -2, .position = 0.5});
    CHECK((at_once - sum).norm() <= 1e-14 * scale);
  }
}

TEST_CASE("spatial inertia: a motion in the plane is the planar element's") {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const double angle = random.between(-3, 3);
    const Eigen::Vector2d span(1.3 * std::cos(angle), 1.3 * std::sin(angle));
    const PlanarElement planar{.span = span, .length = 1.25, .rest_angle = angle + 0.1};
    const SpatialElement spatial{.span = {span.x(), span.y(), 0},
                                 .length = planar.length,
                                 .triad = strandyn::math::rotation({0, 0, planar.rest_angle})};
    const PlanarMotion m{.q = random.vector<PlanarVector>(2.5),
                         .v = random.vector<PlanarVector>(2),
                         .a = random.vector<PlanarVector>(3)};
    const SpatialMotion lifted_m{.q = lifted(m.q), .v = lifted(m.v), .a = lifted(m.a)};
    const Inertia inertia{.mass = mass, .rotary = 0};

    const PlanarVector force = consistent_inertia_force(planar, inertia, m);
    const SpatialVector spatial_force = consistent_inertia_force(spatial, of_section, lifted_m);
    CHECK((spatial_force - lifted(force)).norm() <= 1e-14 * force.norm());
    struct {
      PlanarMatrix mass, velocity, position;
    } const t{.mass = consistent_inertia_tangent(planar, inertia, m, {.acceleration = 1}),
              .velocity = consistent_inertia_tangent(planar, inertia, m, {.velocity = 1}),
              .position = consistent_inertia_tangent(planar, inertia, m, {.position = 1})};
    const Tangents s = tangents(spatial, lifted_m);
    const double scale = t.mass.norm() + t.velocity.norm() + t.position.norm();
    CHECK(planar_difference(s.mass, t.mass) <= 1e-14 * scale);
    CHECK(planar_difference(s.velocity, t.velocity) <= 1e-14 * scale);
    CHECK(planar_difference(s.position, t.position) <= 1e-14 * scale);
  }
}

TEST_CASE("spatial inertia: a tiny rotation loses no digits") {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const SpatialElement element = random.element();
    SpatialMotion m{
        .q = SpatialVector::Zero(), .v = random.vector<SpatialVector>(2), .a = random.vector<SpatialVector>(3)};
    const SpatialMatrix slope = tangents(element, m).position;
    SpatialVector expected = consistent_inertia_force(element, of_section, m);
    m.q = 1e-9 * random.vector<SpatialVector>(1);
    expected += slope * m.q;  // what is left out is of second order, 1e-18
    CHECK((consistent_inertia_force(element, of_section, m) - expected).norm() <= 1e-15 * expected.norm());
  }
}

TEST_CASE("spatial inertia: two nodal bodies carry the mass and the sections of their element") {
  Random random(9);
  const SpatialElement element = random.element();
  const SpatialSectionInertia inertia{.mass = 2, .rotary = 0.3, .polar = 0.7};
  const RigidInertia node = nodal_inertia(element, inertia);
  check_close(2 * node.mass, inertia.mass * element.length, {.relative = 1e-15});
  const Eigen::Matrix3d about_axes = 2 * element.triad.transpose() * node.moment * element.triad;
  const Eigen::Matrix3d expected = element.length * Eigen::Vector3d(0.7, 0.3, 0.3).asDiagonal().toDenseMatrix();
  CHECK((about_axes - expected).norm() <= 1e-15);
}
