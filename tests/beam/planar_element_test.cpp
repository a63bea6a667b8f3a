#include "strandyn/beam/planar_element.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "beam/states.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"

using namespace strandyn::beam;
using strandyn::test::check_close;
using strandyn::test::derivative;
using strandyn::test::moved_rigidly;
using strandyn::test::RandomBeam;

namespace {

constexpr double pi = std::numbers::pi;

struct Response {
  PlanarResultants resultants;
  PlanarSectionTangent tangent;
};

/// A section with every coupling, not symmetric, and not linear: what a return map at partial slip looks like.
Response coupled_section(const PlanarKinematics& k) {
  Response r;
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const double eps = k.eps;
    const double chi = k.chi[g];
    const double uneven = g == 0 ? 1.0 : 1.4;
    r.resultants.N[g] = uneven * (0.3 + 7 * eps + 0.4 * chi + eps * chi);
    r.resultants.M[g] = uneven * (-0.2 + 1.1 * eps + 2 * chi - 0.3 * chi * chi * chi);
    r.tangent.N_eps[g] = uneven * (7 + chi);
    r.tangent.N_chi[g] = uneven * (0.4 + eps);
    r.tangent.M_eps[g] = uneven * 1.1;
    r.tangent.M_chi[g] = uneven * (2 - 0.9 * chi * chi);
  }
  return r;
}

constexpr double EA = 47.1e6;
constexpr double EI = 2387;

PlanarResultants elastic_section(const PlanarKinematics& k) {
  PlanarResultants r;
  for (std::size_t g = 0; g < gauss_points; ++g) {
    r.N[g] = EA * k.eps;
    r.M[g] = EI * k.chi[g];
  }
  return r;
}

/// A member that is unbent and unstretched where its unknowns vanish.
PlanarElement straight(double length) {
  return {.span = {length, 0}, .length = length, .rest_angle = 0};
}

}  // namespace

TEST_CASE("planar element: the tangent is the derivative of the force also for an unsymmetric section") {
  RandomBeam random(1);
  for (int i = 0; i < 200; ++i) {
    const PlanarElement element = random.element();
    const PlanarVector q = random.position(element);
    const auto force = [&](const PlanarVector& at) {
      const PlanarKinematics k = kinematics(element, at);
      return internal_force(element, k, coupled_section(k).resultants);
    };
    const PlanarKinematics k = kinematics(element, q);
    const Response r = coupled_section(k);
    const PlanarMatrix K = tangent(element, k, r.resultants, r.tangent);
    PlanarMatrix expected;
    for (int j = 0; j < 6; ++j) {
      expected.col(j) = derivative([&](double s) { return force(q + s * PlanarVector::Unit(j)); });
    }
    // Measured 3e-11 at most: the error of the differences.
    CHECK((K - expected).lpNorm<Eigen::Infinity>() <= 2e-10 * expected.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("planar element: the tangent is symmetric where the section has a potential") {
  RandomBeam random(2);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarKinematics k = kinematics(element, random.position(element));
    PlanarSectionTangent t;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      t.N_eps[g] = 7;
      t.N_chi[g] = t.M_eps[g] = 1.3;
      t.M_chi[g] = 2;
    }
    const PlanarMatrix K = tangent(element, k, coupled_section(k).resultants, t);
    CHECK((K - K.transpose()).lpNorm<Eigen::Infinity>() <= 1e-14 * K.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("planar element: the internal force is the gradient of the section's stored energy") {
  RandomBeam random(3);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarVector q = random.position(element);
    const auto energy = [&](const PlanarVector& at) {
      const PlanarKinematics k = kinematics(element, at);
      double sum = 0;
      for (std::size_t g = 0; g < gauss_points; ++g) {
        sum += gauss_weight * element.length * (5 * k.eps * k.eps + k.chi[g] * k.chi[g]) / 2;
      }
      return sum;
    };
    const PlanarKinematics k = kinematics(element, q);
    const PlanarVector force = internal_force(element, k, {.N = {5 * k.eps, 5 * k.eps}, .M = {k.chi[0], k.chi[1]}});
    for (int j = 0; j < 6; ++j) {
      const double slope = derivative([&](double s) { return energy(q + s * PlanarVector::Unit(j)); });
      check_close(force(j), slope, {.absolute = 1e-10 * force.norm()});
    }
  }
}

TEST_CASE("planar element: rigid motions from 1e-8 rad to 20 turns leave it free of force") {
  for (const double length : {0.03, 0.3, 3.0}) {
    const PlanarElement element = straight(length);
    for (const double angle : {1e-8, 1e-5, 1e-2, 1.0, pi / 2, 3.0, pi, 4.0, 2 * pi, 40 * pi, 40 * pi + 1}) {
      for (const double turn : {angle, -angle}) {
        const PlanarVector q = moved_rigidly(element, PlanarVector::Zero(), turn, {5, -2});
        const PlanarKinematics k = kinematics(element, q);
        const PlanarVector force = internal_force(element, k, elastic_section(k));
        // The chord is the difference of coordinates of 5 m: rounding of 1e-15 over lengths of 0.03 m.
        CHECK(force.lpNorm<Eigen::Infinity>() <= 1e-12 * EA);
      }
    }
  }
}

TEST_CASE("planar element: a rigid motion turns the force of a strained element and changes nothing else") {
  RandomBeam random(4);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarVector q = random.vector(0.2);
    const double angle = random.between(-60, 60);
    const PlanarKinematics before = kinematics(element, q);
    const PlanarKinematics after = kinematics(element, moved_rigidly(element, q, angle, {0.5, 2}));
    check_close(after.eps, before.eps, {.absolute = 1e-14});
    const PlanarVector here = internal_force(element, before, coupled_section(before).resultants);
    PlanarVector there = internal_force(element, after, coupled_section(after).resultants);
    for (const int node : {0, 3}) there.segment<2>(node) = strandyn::test::turned(there.segment<2>(node), -angle);
    // Turns of 60 rad carry a rounding of 1e-14.
    CHECK((there - here).lpNorm<Eigen::Infinity>() <= 1e-13 * here.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("planar element: its forces are in equilibrium") {
  RandomBeam random(5);
  for (int i = 0; i < 50; ++i) {
    const PlanarElement element = random.element();
    const PlanarVector q = random.position(element);
    const PlanarKinematics k = kinematics(element, q);
    const PlanarVector f = internal_force(element, k, coupled_section(k).resultants);
    const Eigen::Vector2d chord = element.span + q.segment<2>(3) - q.segment<2>(0);
    const double moment = chord.x() * f(4) - chord.y() * f(3) + f(2) + f(5);
    CHECK((f.segment<2>(0) + f.segment<2>(3)).norm() <= 1e-14 * f.norm());
    CHECK(std::abs(moment) <= 1e-14 * f.norm());
  }
}

TEST_CASE("planar element: bent to an arc it has the arc's curvature and a strain of fourth order") {
  const PlanarElement element = straight(2);
  for (const double half : {0.02, 0.1, 0.3}) {
    // Half of the arc's angle is `half`, radius 1/half.
    PlanarVector q = PlanarVector::Zero();
    q(2) = -half;
    q(5) = half;
    q(3) = 2 * std::sin(half) / half - 2;
    const PlanarKinematics k = kinematics(element, q);
    for (const double chi : k.chi) check_close(chi, half, {.relative = 1e-14});
    // sin(h)/h - 1 + h^2/6 = h^4/120 - h^6/5040 ...
    check_close(k.eps, std::pow(half, 4) / 120, {.relative = half * half / 40, .absolute = 1e-15});
  }
}

TEST_CASE("planar element: a linear moment along it is met exactly at the Gauss points") {
  // The Hermite deflection of a cantilever under a tip force is exact: M(x) = P (L - x).
  const PlanarElement element = straight(1);
  const double slope = 1e-4;  // P L^2/(2 EI)
  PlanarVector q = PlanarVector::Zero();
  q(4) = 2 * slope / 3;
  q(5) = slope;
  const PlanarKinematics k = kinematics(element, q);
  for (std::size_t g = 0; g < gauss_points; ++g) {
    // The chord's frame turns by 2e-4/3: curvatures agree up to the square of that.
    check_close(k.chi[g], 2 * slope * (1 - gauss_position[g]), {.relative = 1e-8});
  }
}
