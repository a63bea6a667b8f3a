#include "strandyn/section/spatial_compliant.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "section/one_spatial_point.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::section::CompliantLaw;
using strandyn::section::CompliantOptions;
using strandyn::section::SpatialCompliantLaw;
using strandyn::section::springs_in_space;
using namespace strandyn::test;

namespace {

constexpr double turn = 2 * std::numbers::pi;

double strain_at(double eta) {
  return eta * 162.8e3 / section_constants(curlew()).EA;
}

}  // namespace

TEST_CASE("battery: the spatial compliant law on Curlew, turned by an angle of the grid") {
  check_law(SpatialCompliantLaw(curlew(), {.points = 16, .springs = 8, .smallest_slip = 1e-3, .shifted_chains = false}),
            {.curvature = 0.1, .strain = 5e-4, .torsion = 0.02, .grid_angle = turn / 16, .settling = 8});
}

TEST_CASE("battery: the spatial compliant law with shifted chains and contacts that open") {
  check_law(SpatialCompliantLaw(curlew({.residual_forces = false}), {.points = 12}),
            {.curvature = 0.1, .strain = 5e-4, .torsion = 0.02, .settling = 8});
}

TEST_CASE("battery: the spatial compliant law under high friction") {
  check_law(SpatialCompliantLaw(curlew({.friction = 2.0}), {.points = 8, .springs = 6, .shifted_chains = false}),
            {.curvature = 0.3, .strain = 5e-4, .torsion = 0.02, .grid_angle = turn / 8, .settling = 8});
}

TEST_CASE("battery: the spatial compliant law on a single layer, which touches its core along lines") {
  check_law(SpatialCompliantLaw(steel_1x6(), {.points = 12, .shifted_chains = false}),
            {.curvature = 0.1, .strain = 1e-3, .torsion = 0.1, .grid_angle = turn / 12});
}

TEST_CASE("spatial compliant law: a planar path about axis 2 is the planar law, whatever its chains") {
  for (bool shifted : {true, false}) {
    const CompliantOptions options{.shifted_chains = shifted};
    const SpatialCompliantLaw law(curlew(), options);
    const CompliantLaw planar(curlew(), options);
    const double eps = strain_at(0.2);
    OneSpatialPoint point(law, {.eps = eps});
    OnePoint reference(planar, {.eps = eps, .chi = 0});
    for (int s = 1; s <= 150; ++s) {
      const double chi = 0.05 * std::sin(turn * s / 60) * (1 + 0.3 * std::sin(0.05 * s));
      const double at = eps * (0.8 + 1.1 * std::sin(0.11 * s));
      const auto got = point.respond({.eps = at, .chi2 = chi});
      const auto expected = reference.respond({.eps = at, .chi = chi});
      const double moment = 2400 * 0.05;
      check_close(got.M2, expected.M, {.absolute = 1e-13 * moment}, "M2");
      check_close(got.M3, 0, {.absolute = 1e-13 * moment}, "M3");
      check_close(got.tangent[2][2], expected.dM_dchi, {.relative = 1e-9}, "dM2/dchi2");
      const auto loss = point.commit({.eps = at, .chi2 = chi});
      const auto expected_loss = reference.commit({.eps = at, .chi = chi});
      check_close(loss.stored, expected_loss.stored, {.relative = 1e-13});
      check_close(loss.dissipated, expected_loss.dissipated, {.relative = 1e-12, .absolute = 1e-15 * moment * 0.05});
    }
  }
}

TEST_CASE("spatial compliant law: with one chain for all angles, any direction of the grid is the planar law") {
  const CompliantOptions options{.shifted_chains = false};
  const SpatialCompliantLaw law(curlew(), options);
  const CompliantLaw planar(curlew(), options);
  const double eps = strain_at(0.2);
  for (int cell : {1, 5, 9, 14, 27}) {
    const double angle = turn * cell / 36;
    OneSpatialPoint point(law, {.eps = eps});
    OnePoint reference(planar, {.eps = eps, .chi = 0});
    for (int s = 1; s <= 60; ++s) {
      const double chi = 0.05 * std::sin(turn * s / 40) * (1 + 0.3 * std::sin(0.05 * s));
      const double at = eps * (1 + 0.3 * std::sin(0.11 * s));
      const SpatialStrain to{.eps = at, .chi2 = chi * std::cos(angle), .chi3 = chi * std::sin(angle)};
      const auto got = point.respond(to);
      const double expected = reference.respond({.eps = at, .chi = chi}).M;
      const double moment = 2400 * 0.05;
      check_close(got.M2 * std::cos(angle) + got.M3 * std::sin(angle), expected, {.absolute = 1e-12 * moment}, "along");
      check_close(got.M3 * std::cos(angle) - got.M2 * std::sin(angle), 0, {.absolute = 1e-12 * moment}, "across");
      const auto loss = point.commit(to);
      check_close(loss.dissipated, reference.commit({.eps = at, .chi = chi}).dissipated,
                  {.relative = 1e-11, .absolute = 1e-14 * moment * 0.05});
    }
  }
}

namespace {

/// Loss of the fourth turn along a path of curvature that closes in `steps`. [J/m]
template <class Path>
double loss_per_turn(const strandyn::section::Law& law, double eps, int steps, const Path& path) {
  OneSpatialPoint point(law, {.eps = eps});
  double loss = 0;
  for (int s = 1; s <= 4 * steps; ++s) {
    // The amplitude comes gently in the first turn.
    const double part = std::min(1.0, static_cast<double>(s) / steps);
    const auto [chi2, chi3] = path(turn * s / steps);
    const auto step = point.commit({.eps = eps, .chi2 = part * chi2, .chi3 = part * chi3});
    if (s > 3 * steps) loss += step.dissipated - step.quadrature_error;
  }
  return loss;
}

}  // namespace

TEST_CASE("spatial compliant law: a single wire is a rod and twist and tension act on the lays with their signs") {
  Strand wire;
  wire.layers = {round_layer(1, 4e-3, 0, 70e9)};
  const auto c = section_constants(wire);
  const auto rod = OneSpatialPoint(SpatialCompliantLaw(wire), {.eps = 1e-3})
                       .respond({.eps = 1e-3, .chi1 = 0.1, .chi2 = 3, .chi3 = -6});
  check_close(rod.M2, c.EI_min * 3, {.relative = 1e-14});
  check_close(rod.M3, c.EI_min * -6, {.relative = 1e-14});
  check_close(rod.M1, c.GJ * 0.1, {.relative = 1e-14});

  const SpatialCompliantLaw law(steel_1x6());  // right-hand lay
  const auto slipped = [&](double chi1) {
    return OneSpatialPoint(law, {.eps = 1e-3, .chi1 = chi1}).respond({.eps = 1e-3, .chi1 = chi1, .chi2 = 1}).M2;
  };
  CHECK(slipped(0.2) > slipped(0.0));
  CHECK(slipped(0.0) > slipped(-0.2));
}

TEST_CASE("spatial compliant law: from 1e-12 to 1e2 1/m, slack or pulled, twisted either way, everything is finite") {
  for (double friction : {0.0, 0.5, 30.0}) {
    check_finite_anywhere(SpatialCompliantLaw(curlew({.friction = friction}), {.points = 12}));
  }
}

TEST_CASE("spatial compliant law: orbits and oblique lines lose at 36 points what they lose at 288, within 1 %") {
  const double eps = strain_at(0.2);
  const SpatialCompliantLaw usual(curlew(), {.springs = springs_in_space});
  const SpatialCompliantLaw fine(curlew(), {.points = 288, .springs = springs_in_space});
  struct Orbit {
    const char* name;
    double along, across, direction;  // half axes [1/m], direction of the first [rad]
  };
  for (const double size : {1e-4, 1e-2, 5e-2}) {
    for (const Orbit& o : {Orbit{"circle", 1, 1, 0}, Orbit{"ellipse", 1, 0.3, 0.6}, Orbit{"oblique line", 1, 0, 0.7},
                           Orbit{"line across", 1, 0, turn / 4}}) {
      const auto path = [&](double at) {
        const double a = size * o.along * std::sin(at);
        const double b = size * o.across * std::cos(at);
        return std::pair{a * std::cos(o.direction) - b * std::sin(o.direction),
                         a * std::sin(o.direction) + b * std::cos(o.direction)};
      };
      const double expected = loss_per_turn(fine, eps, 60, path);
      CHECK(expected > 0);
      check_close(loss_per_turn(usual, eps, 60, path), expected, {.relative = 0.01},
                  fmt::format("{}, {} 1/m", o.name, size));
    }
  }
}

TEST_CASE("spatial compliant law: a small circular orbit loses 3 pi/4 of what a line of its radius loses") {
  // Losses go with the cube: a line shows an angle |cos(theta)| of its amplitude, a circle shows all of it, and the
  // mean of |cos|^3 is 4/(3 pi). One layer without feedback of the force would be exact.
  const SpatialCompliantLaw law(curlew(), {.springs = springs_in_space});
  const double eps = strain_at(0.2);
  for (double size : {1e-4, 5e-4}) {
    const double circle = loss_per_turn(law, eps, 120, [&](double at) {
      return std::pair{size * std::cos(at), size * std::sin(at)};
    });
    const double line = loss_per_turn(law, eps, 120, [&](double at) { return std::pair{size * std::sin(at), 0.0}; });
    check_close(circle / line, 3 * std::numbers::pi / 4, {.relative = 0.01}, fmt::format("{} 1/m", size));
  }
}
