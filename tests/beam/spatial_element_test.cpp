#include "strandyn/beam/spatial_element.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "beam/spatial_states.hpp"
#include "beam/states.hpp"
#include "strandyn/math/rotation.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using namespace strandyn::beam;
using strandyn::math::rotation;
using strandyn::test::check_close;
using strandyn::test::derivative;
using strandyn::test::elastic_section;
using strandyn::test::force_at;
using strandyn::test::LinearSection;
using strandyn::test::moved_rigidly;
using strandyn::test::RandomSpatialBeam;
using strandyn::test::strain;
using strandyn::test::tangent_at;

namespace {

constexpr double pi = std::numbers::pi;

/// The axes after a quarter turn about the first.
Matrix3d quarter_turn() {
  Matrix3d m;
  m << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return m;
}

}  // namespace

TEST_CASE("spatial element: the tangent is the derivative of the force for a section that is not symmetric") {
  RandomSpatialBeam random(1);
  for (int i = 0; i < 100; ++i) {
    const SpatialElement element = random.element();
    SpatialVector q = random.position(element);
    // Some nodes count a turn more than they need.
    if (i % 5 == 0) q.segment<3>(3) *= 1 + 2 * pi / q.segment<3>(3).norm();
    const LinearSection section = random.section();
    SpatialMatrix expected;
    for (int j = 0; j < 12; ++j) {
      expected.col(j) =
          derivative([&](double s) { return force_at(element, q + s * SpatialVector::Unit(j), section); });
    }
    const double error = (tangent_at(element, q, section) - expected).lpNorm<Eigen::Infinity>();
    // Measured 6e-12: the error of the differences; more where a vector counts a turn.
    CHECK(error <= 2e-10 * expected.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("spatial element: the force is the gradient of the energy and the tangent its symmetric Hessian") {
  RandomSpatialBeam random(2);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialVector q = random.position(element);
    LinearSection section = random.section();
    for (Matrix4d& C : section.C) C = (C + C.transpose()).eval();
    const auto energy = [&](const SpatialVector& at) {
      const SpatialKinematics k = kinematics(element, at);
      double sum = 0;
      for (std::size_t g = 0; g < gauss_points; ++g) {
        const Vector4d s = strain(k, g);
        sum += gauss_weight * element.length * (section.offset[g].dot(s) + s.dot(section.C[g] * s) / 2);
      }
      return sum;
    };
    const SpatialVector force = force_at(element, q, section);
    for (int j = 0; j < 12; ++j) {
      const double slope = derivative([&](double s) { return energy(q + s * SpatialVector::Unit(j)); });
      check_close(force(j), slope, {.absolute = 1e-10 * force.norm()});
    }
    const SpatialMatrix K = tangent_at(element, q, section);
    CHECK((K - K.transpose()).lpNorm<Eigen::Infinity>() <= 2e-14 * K.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("spatial element: rigid motions from 1e-8 rad to 20 turns leave it free of strain and force") {
  RandomSpatialBeam random(3);
  for (int i = 0; i < 20; ++i) {
    const Matrix3d axes = rotation(3 * random.direction());
    const SpatialElement element = {.span = 0.3 * axes.col(0), .length = 0.3, .triad = axes};
    for (const double angle : {1e-8, 1e-5, 1e-2, 1.0, pi / 2, 3.0, pi, 4.0, 2 * pi, 40 * pi, 40 * pi - 1}) {
      const Vector3d psi = angle * random.direction();
      SpatialVector q = moved_rigidly(element, SpatialVector::Zero(), rotation(psi), random.vector(5));
      for (int at : {3, 9}) q.segment<3>(at) = psi;  // with all its turns
      const SpatialKinematics k = kinematics(element, q);
      // The chord is the difference of coordinates of 5 m: rounding of 1e-15 over a length of 0.3 m.
      for (std::size_t g = 0; g < gauss_points; ++g) {
        CHECK((strain(k, g).cwiseAbs().array() <= Eigen::Array4d(1e-14, 1e-14, 1e-13, 1e-13)).all());
      }
      CHECK(force_at(element, q, elastic_section()).lpNorm<Eigen::Infinity>() <= 2e-14 * 5e7);
    }
  }
}

TEST_CASE("spatial element: a turn of everything turns the force and changes no strain") {
  RandomSpatialBeam random(4);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialVector q = random.position(element);
    const LinearSection section = random.section();
    const Matrix3d turn = rotation(random.between(0, 10) * random.direction());
    const SpatialKinematics before = kinematics(element, q);
    const SpatialVector force = internal_force(element, before, section(before));
    // The world turned: reference, unknowns and all. Every vector turns with it.
    SpatialVector turned;
    SpatialVector expected;
    for (int at : {0, 3, 6, 9}) {
      turned.segment<3>(at) = turn * q.segment<3>(at);
      expected.segment<3>(at) = turn * force.segment<3>(at);
    }
    const SpatialElement other = {.span = turn * element.span, .length = element.length, .triad = turn * element.triad};
    CHECK((force_at(other, turned, section) - expected).norm() <= 1e-13 * force.norm());

    // The body turned in the world: forces turn, and so do the moments on the spins.
    const SpatialVector moved = moved_rigidly(element, q, turn, {0.5, 2, -1});
    const SpatialKinematics after = kinematics(element, moved);
    const SpatialVector there = internal_force(element, after, section(after));
    for (std::size_t g = 0; g < gauss_points; ++g) CHECK((strain(after, g) - strain(before, g)).norm() <= 2e-14);
    for (int at : {0, 6}) {
      CHECK((there.segment<3>(at) - turn * force.segment<3>(at)).norm() <= 1e-13 * force.norm());
      const auto moment = [&](const SpatialVector& f, const SpatialVector& unknowns) -> Vector3d {
        return strandyn::math::inverse_spin_map(unknowns.segment<3>(at + 3)).transpose() * f.segment<3>(at + 3);
      };
      CHECK((moment(there, moved) - turn * moment(force, q)).norm() <= 1e-13 * force.norm());
    }
  }
}

TEST_CASE("spatial element: its forces are in equilibrium") {
  RandomSpatialBeam random(5);
  for (int i = 0; i < 50; ++i) {
    const SpatialElement element = random.element();
    const SpatialVector q = random.position(element);
    const SpatialVector f = force_at(element, q, random.section());
    const Vector3d chord = element.span + q.segment<3>(6) - q.segment<3>(0);
    Vector3d moment = chord.cross(f.segment<3>(6));
    for (int at : {3, 9}) {
      moment += strandyn::math::inverse_spin_map(q.segment<3>(at)).transpose() * f.segment<3>(at);
    }
    CHECK((f.segment<3>(0) + f.segment<3>(6)).norm() <= 1e-14 * f.norm());
    CHECK(moment.norm() <= 2e-14 * f.norm());
  }
}

TEST_CASE("spatial element: in the plane it is the planar element whichever of its axes stands upright") {
  strandyn::test::RandomBeam random(6);
  const std::array<int, 6> plane = {0, 1, 5, 6, 7, 11};  // x, y and the rotation about z
  for (int i = 0; i < 100; ++i) {
    const PlanarElement flat = random.element();
    const PlanarVector q = random.position(flat);
    const PlanarKinematics k = kinematics(flat, q);
    const PlanarResultants r = {.N = {0.7, -0.4}, .M = {1.1, 0.6}};
    const PlanarVector force = internal_force(flat, k, r);
    const PlanarMatrix K =
        tangent(flat, k, r, {.N_eps = {7, 8}, .N_chi = {0.4, 0.3}, .M_eps = {1.1, 0.9}, .M_chi = {2, 3}});

    SpatialElement element = {.span = Vector3d::Zero(), .length = flat.length, .triad = {}};
    element.span.head<2>() = flat.span;
    element.triad = rotation({0, 0, flat.rest_angle});
    SpatialVector unknowns = SpatialVector::Zero();
    for (int j = 0; j < 6; ++j) unknowns(plane[j]) = q(j);
    for (const bool rolled : {false, true}) {
      // After a quarter turn about axis 1, axis 2 points to where axis 3 did.
      if (rolled) element.triad *= quarter_turn();
      const int bending = rolled ? 2 : 3;
      const SpatialKinematics here = kinematics(element, unknowns);
      SpatialResultants spatial = {.N = r.N};
      (rolled ? spatial.M2 : spatial.M3) = r.M;
      SpatialSectionTangent t;
      for (std::size_t g = 0; g < gauss_points; ++g) {
        const Vector4d s = strain(here, g);
        check_close(s(0), k.eps, {.absolute = 1e-14});
        check_close(s(bending), k.chi[g], {.absolute = 1e-14});
        check_close(s(1), 0, {.absolute = 1e-15});
        check_close(s(5 - bending), 0, {.absolute = 1e-15});
        t.C[g].setConstant(0.2);  // what couples to the other strains does not touch the plane
        t.C[g](0, 0) = g == 0 ? 7 : 8;
        t.C[g](0, bending) = g == 0 ? 0.4 : 0.3;
        t.C[g](bending, 0) = g == 0 ? 1.1 : 0.9;
        t.C[g](bending, bending) = g == 0 ? 2 : 3;
      }
      const SpatialVector f = internal_force(element, here, spatial);
      const SpatialMatrix there = tangent(element, here, spatial, t);
      check_close(f.norm(), force.norm(), {.relative = 1e-13});  // nothing out of the plane
      for (int a = 0; a < 6; ++a) {
        check_close(f(plane[a]), force(a), {.absolute = 1e-13 * force.norm()});
        for (int b = 0; b < 6; ++b) {
          check_close(there(plane[a], plane[b]), K(a, b), {.absolute = 1e-13 * K.lpNorm<Eigen::Infinity>()});
        }
      }
    }
  }
}

TEST_CASE("spatial element: with its axes exchanged it is the same up to third order of bending") {
  // The frame leans on axis 2 of the nodes. Leaning on axis 3 it would roll by a product of two bendings.
  RandomSpatialBeam random(7);
  for (int i = 0; i < 20; ++i) {
    const SpatialElement element = {.span = {1, 0, 0}, .length = 1};
    const SpatialElement rolled = {.span = {1, 0, 0}, .length = 1, .triad = quarter_turn()};
    const Vector3d first = random.direction();
    const Vector3d second = random.direction();
    const auto difference = [&](double size) {
      SpatialVector q = SpatialVector::Zero();
      q.segment<3>(3) = size * first;
      q.segment<3>(9) = size * second;
      const SpatialKinematics here = kinematics(element, q);
      const SpatialKinematics there = kinematics(rolled, q);
      double sum = 0;
      for (std::size_t g = 0; g < gauss_points; ++g) {
        // New axis 2 is old axis 3, new axis 3 is old axis 2 reversed.
        const Vector4d expected(here.eps, here.chi1, here.chi3[g], -here.chi2[g]);
        sum += (strain(there, g) - expected).norm();
      }
      return sum;
    };
    // Terms of fourth order are left: 3 % where those of third order happen to be small.
    check_close(difference(2e-3) / difference(1e-3), 8, {.relative = 0.05});
  }
}

TEST_CASE("spatial element: a motion of 1e-9 rad keeps the digits of its curvature") {
  // Along a global axis nothing is subtracted from unity: the planar element, 1e-9 as small, agrees to its own
  // rounding.
  const PlanarElement flat = {.span = {0.5, 0}, .length = 0.5, .rest_angle = 0};
  const SpatialElement element = {.span = {0.5, 0, 0}, .length = 0.5};
  PlanarVector q;
  q << 1e-10, 3e-10, 1e-9, -2e-10, 1.7e-10, -4e-10;
  SpatialVector unknowns = SpatialVector::Zero();
  for (int node : {0, 1}) {
    unknowns.segment<2>(6 * node) = q.segment<2>(3 * node);
    unknowns(6 * node + 5) = q(3 * node + 2);
  }
  const PlanarKinematics expected = kinematics(flat, q);
  const SpatialKinematics k = kinematics(element, unknowns);
  for (std::size_t g = 0; g < gauss_points; ++g) check_close(k.chi3[g], expected.chi[g], {.relative = 3e-15});
}
