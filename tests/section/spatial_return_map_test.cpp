#include "strandyn/section/spatial_return_map.hpp"

#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/one_point.hpp"
#include "section/one_spatial_point.hpp"
#include "section/plain_spatial_return_map.hpp"
#include "section/random_paths.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::section::PlanarReturnMap;
using strandyn::section::SpatialReturnMap;
using namespace strandyn::test;

namespace {

constexpr double turn = 2 * std::numbers::pi;

double strain_at(double eta) {
  return eta * 162.8e3 / section_constants(curlew()).EA;
}

SpatialStrain turned(SpatialStrain s, double angle) {
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return {s.eps, s.chi1, c * s.chi2 - n * s.chi3, n * s.chi2 + c * s.chi3};
}

/// Planar cycles of growing and changing amplitude while the tension moves, -30 % to +90 % around `eps`.
struct PlanarPath {
  double eps;
  double amplitude;
  PlanarStrain operator()(int step) const {
    return {.eps = eps * (0.8 + 1.1 * std::sin(0.11 * step)),
            .chi = amplitude * std::sin(turn * step / 133.0) * (1 + 0.3 * std::sin(0.05 * step))};
  }
};

}  // namespace

TEST_CASE("spatial return map: random paths with moving tension and twist agree with the plain implementation") {
  const LawDescription what{.curvature = 0.1, .strain = strain_at(0.15), .torsion = 0.02};
  for (const Strand& strand : {curlew(), curlew({.friction = 0.4, .residual_forces = false})}) {
    const SpatialReturnMap law(strand, {.points = 36});
    const double EI_min = section_constants(strand).EI_min;
    const double moment = section_constants(strand).EI_max * what.curvature;
    const auto path = random_paths(strandyn::section::Dimension::spatial, what, {.points = 20, .steps = 60});
    double furthest_mean = 0;
    for (std::size_t p = 0; p < 20; ++p) {
      using enum strandyn::section::Component;
      const auto at = [&](std::size_t s) {
        return SpatialStrain{path[s][axial][p], path[s][torsion][p], path[s][bending2][p], path[s][bending3][p]};
      };
      OneSpatialPoint point(law, at(0));
      PlainSpatialReturnMap plain(strand, 36);
      plain.step({.eps = at(0).eps});
      for (std::size_t s = 1; s < path.size(); ++s) {
        const SpatialStrain to = at(s);
        const auto expected = plain.step({to.eps, to.chi1, to.chi2, to.chi3});
        const auto got = point.respond(to);
        const auto loss = point.commit(to);
        // The repetition stops when forces move by less than 1e-16 EA_w; the moment then stands to twelve digits.
        const Within close{.absolute = 1e-12 * moment};
        check_close(got.M2, expected.M2, close, "M2");
        check_close(got.M3, expected.M3, close, "M3");
        const Within energy{.absolute = 1e-12 * moment * what.curvature};
        const auto c = section_constants(strand);
        const double linear = c.EA * to.eps * to.eps / 2 + c.C_AT * to.eps * to.chi1 + c.GJ * to.chi1 * to.chi1 / 2 +
                              EI_min * (to.chi2 * to.chi2 + to.chi3 * to.chi3) / 2;
        check_close(loss.stored - linear, expected.stored, energy, "stored");
        check_close(loss.dissipated, expected.dissipated, energy, "dissipated");
        check_close(loss.quadrature_error, expected.quadrature_error, energy, "quadrature error");
        furthest_mean = std::max(furthest_mean, expected.mean_over_limit);
      }
    }
    // The closure is at work: q does not close by itself (measured 0.16 and 0.08 of the mean limit).
    CHECK(furthest_mean > 0.01);
  }
}

TEST_CASE("spatial return map: a planar path along a grid direction is the planar law, to rounding") {
  const PlanarPath path{.eps = strain_at(0.15), .amplitude = 0.06};
  const double moment = section_constants(curlew()).EI_max * path.amplitude;
  for (int points : {12, 36, 72}) {
    const PlanarReturnMap planar(curlew(), points);
    const SpatialReturnMap spatial(curlew(), {.points = points});
    for (int turns = 0; turns < points; turns += points / 12) {
      const double angle = turns * turn / points;
      OnePoint expected(planar, path(0));
      OneSpatialPoint point(spatial, {.eps = path(0).eps});
      double worst_moment = 0;
      double worst_loss = 0;
      double worst_error = 0;
      for (int s = 1; s <= 300; ++s) {
        const PlanarStrain to = path(s);
        const SpatialStrain there = turned({.eps = to.eps, .chi2 = to.chi}, angle);
        const auto want = expected.respond(to);
        const auto got = point.respond(there);
        const double along = std::cos(angle) * got.M2 + std::sin(angle) * got.M3;
        const double across = std::cos(angle) * got.M3 - std::sin(angle) * got.M2;
        worst_moment = std::max({worst_moment, std::abs(along - want.M), std::abs(across)});
        const auto want_loss = expected.commit(to);
        const auto loss = point.commit(there);
        worst_loss = std::max(worst_loss, std::abs(loss.dissipated - want_loss.dissipated));
        worst_error = std::max(worst_error, std::abs(loss.quadrature_error - want_loss.quadrature_error));
      }
      check_close(worst_moment, 0, {.absolute = 1e-13 * moment});
      check_close(worst_loss, 0, {.absolute = 1e-13 * moment * path.amplitude});
      check_close(worst_error, 0, {.absolute = 1e-13 * moment * path.amplitude});
    }
  }
}

TEST_CASE("spatial return map: between grid directions the answer nears the planar one with the square of the points") {
  const double eps = strain_at(0.15);
  // The virgin curve from stick to slip: the largest miss over the directions within a cell, along and across.
  const auto miss = [&](int points) {
    const PlanarReturnMap exact(curlew(), 1440);
    const SpatialReturnMap law(curlew(), {.points = points});
    double worst = 0;
    for (double part : {0.1, 0.2, 0.3, 0.4, 0.5}) {
      const double angle = part * turn / points;
      OnePoint expected(exact, {.eps = eps});
      OneSpatialPoint point(law, {.eps = eps});
      for (int s = 1; s <= 60; ++s) {
        const double chi = 0.001 * s;
        const double M = expected.respond({.eps = eps, .chi = chi}).M;
        const auto got = point.respond(turned({.eps = eps, .chi2 = chi}, angle));
        const double along = std::cos(angle) * got.M2 + std::sin(angle) * got.M3;
        const double across = std::cos(angle) * got.M3 - std::sin(angle) * got.M2;
        worst = std::max(worst, std::hypot(along - M, across) / M);
        expected.commit({.eps = eps, .chi = chi});
        point.commit(turned({.eps = eps, .chi2 = chi}, angle));
      }
    }
    return worst;
  };
  const double at_36 = miss(36);
  const double at_72 = miss(72);
  const double at_144 = miss(144);
  // Measured on the virgin curve: 1.6e-3, 6.3e-4, 1.7e-4.
  CHECK(at_36 < 2e-3);
  CHECK(at_72 < 8e-4);
  CHECK(at_36 / at_144 > 8);  // 16 for a clean second order; single cells change from stick to slip in steps
}

TEST_CASE(
    "spatial return map: a small vibration makes no march, whatever its direction, and answers as one that does") {
  const double eps = strain_at(0.15);
  const Strand strand = curlew();
  const SpatialReturnMap law(strand, {.points = 36});
  for (double direction : {0.0, 0.4, 1.3}) {
    OneSpatialPoint point(law, {.eps = eps});
    PlainSpatialReturnMap plain(strand, 36);
    plain.step({.eps = eps});
    // Sagged first, far enough to slip; then vibrations around that state, the tension following a little.
    for (int s = 1; s <= 20; ++s) {
      const SpatialStrain to{.eps = eps, .chi2 = 0.001 * s};
      point.commit(to);
      plain.step({.eps = eps, .chi2 = to.chi2});
    }
    int marched = 0;
    for (int s = 1; s <= 400; ++s) {
      const double a = 1e-4 * std::sin(turn * s / 50);
      const SpatialStrain to{.eps = eps * (1 + 1e-3 * std::sin(turn * s / 25)),
                             .chi1 = 1e-5 * std::sin(turn * s / 40),
                             .chi2 = 0.0199 + a * std::cos(direction),
                             .chi3 = a * std::sin(direction)};
      const auto expected = plain.step({to.eps, to.chi1, to.chi2, to.chi3});
      const auto got = point.respond(to);
      const double moment = 2400 * 0.02;
      check_close(got.M2, expected.M2, {.absolute = 1e-12 * moment});
      check_close(got.M3, expected.M3, {.absolute = 1e-12 * moment});
      if (point.commit(to).swept) ++marched;
    }
    // Steps that slip march; so do those near the tips of the kite. Measured: 33, 69, 64.
    CHECK(marched < 100);
    OneSpatialPoint virgin(law, {.eps = eps});
    for (int s = 1; s <= 100; ++s) {
      const double a = 1e-4 * std::sin(turn * s / 50);
      const SpatialStrain to{.eps = eps * (1 + 1e-3 * std::sin(turn * s / 25)),
                             .chi2 = a * std::cos(direction),
                             .chi3 = a * std::sin(direction)};
      CHECK(!virgin.respond(to).swept);
      CHECK(!virgin.commit(to).swept);
    }
  }
}

TEST_CASE("spatial return map: without friction it is EI_min, with friction without bound EI_max, and loses nothing") {
  const double eps = strain_at(0.15);
  for (double friction : {0.0, 1e6}) {
    const Strand strand = curlew({.friction = friction});
    const auto c = section_constants(strand);
    const double EI = friction == 0 ? c.EI_min : c.EI_max;
    const SpatialReturnMap law(strand, {.points = 36});
    OneSpatialPoint point(law, {.eps = eps});
    for (int s = 1; s <= 100; ++s) {
      const SpatialStrain to{.eps = eps, .chi2 = 0.02 * std::sin(0.1 * s), .chi3 = 0.03 * std::sin(0.23 * s)};
      const auto got = point.respond(to);
      check_close(got.M2, EI * to.chi2, {.absolute = 1e-12 * EI * 0.03});
      check_close(got.M3, EI * to.chi3, {.absolute = 1e-12 * EI * 0.03});
      CHECK(point.commit(to).dissipated == 0);
    }
  }
}

TEST_CASE("spatial return map: a single wire is a rod that loses nothing and is never swept") {
  Strand wire;
  wire.layers = {round_layer(1, 4e-3, 0, 70e9)};
  const SpatialReturnMap law(wire, {.points = 36});
  const auto c = section_constants(wire);
  OneSpatialPoint point(law, {.eps = 1e-3});
  for (double chi : {0.1, -20.0, 3.0}) {
    const SpatialStrain to{.eps = 1e-3, .chi1 = 0.1, .chi2 = chi, .chi3 = 2 * chi};
    const auto got = point.respond(to);
    check_close(got.M2, c.EI_min * chi, {.relative = 1e-14});
    check_close(got.M3, c.EI_min * 2 * chi, {.relative = 1e-14});
    check_close(got.M1, c.GJ * 0.1, {.relative = 1e-14});
    CHECK(!got.swept);
    const auto loss = point.commit(to);
    CHECK(!loss.swept);
    CHECK(loss.dissipated == 0);
  }
}

TEST_CASE("spatial return map: any curvature, slack or pulled, twisted either way, gives finite numbers") {
  for (double friction : {0.3, 3.0, 30.0}) {
    check_finite_anywhere(SpatialReturnMap(curlew({.friction = friction}), {.points = 36}));
  }
}

TEST_CASE("spatial return map: twist tightens the lays of one hand and loosens the others, with its sign") {
  const SpatialReturnMap law(steel_1x6(), {.points = 36});  // right-hand lay
  const double chi = 1.0;
  const auto slip_moment = [&](double chi1) {
    return OneSpatialPoint(law, {.eps = 1e-3, .chi1 = chi1}).respond({.eps = 1e-3, .chi1 = chi1, .chi2 = chi}).M2;
  };
  const auto strained = [&](double eps) {
    return OneSpatialPoint(law, {.eps = eps}).respond({.eps = eps, .chi2 = chi}).M2;
  };
  // F_at = EA_w (cos^2 eps + R sin cos chi1): a twist does what the strain R tan(a) chi1 does.
  const Layer wire = steel_1x6().layers[1];
  const double same = wire.helix_radius * std::tan(wire.lay_angle) * 0.2;
  check_close(slip_moment(0.2), strained(1e-3 + same), {.relative = 1e-12});
  check_close(slip_moment(-0.2), strained(1e-3 - same), {.relative = 1e-12});
  CHECK(slip_moment(0.2) > slip_moment(-0.2));
}

TEST_CASE("spatial return map: the bending part of the axial resultants has a tangent and its work can be booked") {
  const Strand strand = curlew();
  const double eps = strain_at(0.15);
  const SpatialReturnMap law(strand, {.points = 36, .axial_resultants = true});
  const SpatialReturnMap without(strand, {.points = 36});
  OneSpatialPoint point(law, {.eps = eps});
  OneSpatialPoint reference(without, {.eps = eps});
  SpatialStrain before{.eps = eps};
  auto last = point.respond(before);
  double stored = point.commit(before).stored;
  double N_before = 0;
  double M1_before = 0;
  double largest = 0;
  for (int s = 1; s <= 80; ++s) {
    const SpatialStrain to{.eps = eps * (1 + 0.2 * std::sin(0.3 * s)),
                           .chi1 = 0.01 * std::sin(0.2 * s),
                           .chi2 = 0.05 * std::sin(0.1 * s),
                           .chi3 = 0.04 * std::sin(0.17 * s)};
    const auto got = point.respond(to);
    const auto plain = reference.respond(to);
    CHECK(got.M2 == plain.M2);
    CHECK(got.M3 == plain.M3);
    if (s % 10 == 0) {
      const double step[] = {1e-7 * eps, 1e-9, 1e-9, 1e-9};
      for (std::size_t y = 0; y < 4; ++y) {
        SpatialStrain up = to;
        SpatialStrain down = to;
        double* const ups[] = {&up.eps, &up.chi1, &up.chi2, &up.chi3};
        double* const downs[] = {&down.eps, &down.chi1, &down.chi2, &down.chi3};
        *ups[y] += step[y];
        *downs[y] -= step[y];
        const auto a = point.respond(up);
        const auto b = point.respond(down);
        const double width = *ups[y] - *downs[y];
        const double scale = y == 0 ? 1 / eps : 1 / 0.05;
        // Resultants of the bending part are some 200 N and 0.1 N m; N itself is 24 kN and known to 4e-12 N.
        check_close(got.tangent[0][y], (a.N - b.N) / width, {.relative = 1e-6, .absolute = 1e-4 * scale}, "dN");
        check_close(got.tangent[1][y], (a.M1 - b.M1) / width, {.relative = 1e-6, .absolute = 1e-7 * scale}, "dM1");
      }
    }
    const auto loss = point.commit(to);
    reference.commit(to);
    const auto wires = point.wires();
    const auto c = section_constants(strand);
    check_close(got.N, c.EA * to.eps + c.C_AT * to.chi1 + wires.N_bending, {.relative = 1e-12});
    check_close(got.M1, c.C_AT * to.eps + c.GJ * to.chi1 + wires.M1_bending, {.absolute = 1e-12 * 30});
    const double coupling = (N_before + wires.N_bending) / 2 * (to.eps - before.eps) +
                            (M1_before + wires.M1_bending) / 2 * (to.chi1 - before.chi1);
    const double work =
        (last.N + got.N) / 2 * (to.eps - before.eps) + (last.M1 + got.M1) / 2 * (to.chi1 - before.chi1) +
        (last.M2 + got.M2) / 2 * (to.chi2 - before.chi2) + (last.M3 + got.M3) / 2 * (to.chi3 - before.chi3);
    check_close(loss.stored - stored + loss.dissipated - loss.quadrature_error + coupling, work,
                {.absolute = 1e-12 * (std::abs(stored) + std::abs(work))});
    largest = std::max(largest, std::abs(wires.N_bending));
    stored = loss.stored;
    last = got;
    before = to;
    N_before = wires.N_bending;
    M1_before = wires.M1_bending;
  }
  CHECK(largest > 100);  // of 24 kN
}
