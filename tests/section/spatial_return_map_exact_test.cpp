#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/one_spatial_point.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::section::SpatialReturnMap;
using namespace strandyn::test;

namespace {

constexpr double turn = 2 * std::numbers::pi;

SpatialStrain turned(SpatialStrain s, double angle) {
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return {s.eps, s.chi1, c * s.chi2 - n * s.chi3, n * s.chi2 + c * s.chi3};
}

/// A layer held by straight wires that press with their residual force alone: its limit is the same at every angle and
/// for every force. The straight wires stick.
struct ConstantLimit {
  Strand strand;
  double q_lim = 0;       ///< [N/m]
  double first_slip = 0;  ///< [1/m]
  double C = 0;           ///< [m^2]
  double EI = 0;          ///< [N m^2] what sticking adds, of the layer
  double EI_rest = 0;     ///< [N m^2] everything else

  ConstantLimit() {
    constexpr double d = 3e-3;
    constexpr double angle = 12 * degrees;
    strand.layers = {round_layer(1, d, 0, 70e9), round_layer(6, d, angle, 70e9), round_layer(12, d, 0, 70e9)};
    fill_helix_radii(strand);
    strand.layers[2].friction_inner = 0.5;
    strand.layers[2].residual_force = 400;
    const Layer& wire = strand.layers[1];
    q_lim = 0.5 * (1 + std::pow(std::sin(angle), 2) / wire.helix_radius * d / 2) * 2 * 400;
    const double k = wire.EA_wire() * std::pow(std::cos(angle), 2) * std::sin(angle);
    first_slip = q_lim / k;
    C = 6 * std::pow(wire.helix_radius, 2) / std::tan(angle);
    EI = C * k / 2;
    EI_rest = section_constants(strand).EI_max - EI;
  }
};

}  // namespace

TEST_CASE("spatial return map: under a constant limit a circular orbit of curvature loses 4 C q_lim (chi - chi_cr)") {
  const ConstantLimit held;
  const SpatialReturnMap law(held.strand, {.points = 36});
  constexpr int steps = 720;  // a turn
  for (double x : {0.9, 1.2, 2.0, 5.0}) {
    const double chi = x * held.first_slip;
    OneSpatialPoint point(law, {.eps = 1e-4});
    for (int s = 1; s <= 50; ++s) point.commit({.eps = 1e-4, .chi2 = chi * s / 50});
    double lost = 0;
    for (int s = 1; s <= 3 * steps; ++s) {
      const auto loss = point.commit(turned({.eps = 1e-4, .chi2 = chi}, turn * s / steps));
      if (s > 2 * steps) lost += loss.dissipated;
    }
    // Midpoints do not meet the turning points of e exactly: the last increment before each reversal is cut short by at
    // most (1 - cos(pi/720)) chi = 1e-5 chi.
    const double expected = 4 * held.C * held.q_lim * std::max(0.0, chi - held.first_slip);
    check_close(lost, expected, {.relative = 1e-4, .absolute = 1e-12});
  }
}

TEST_CASE("spatial return map: under a constant limit planar loops in any direction are the closed form") {
  const ConstantLimit held;
  const SpatialReturnMap law(held.strand, {.points = 72});
  for (double angle : {0.0, 0.3 * turn / 72, 0.5 * turn / 72, 0.7}) {
    for (double x : {1.2, 1.5, 3.0, 8.0}) {
      const double chi = x * held.first_slip;
      OneSpatialPoint point(law, {.eps = 1e-4});
      const auto virgin = point.respond(turned({.eps = 1e-4, .chi2 = chi}, angle));
      const double M = std::cos(angle) * virgin.M2 + std::sin(angle) * virgin.M3 - held.EI_rest * chi;
      const double M_exact =
          2 / std::numbers::pi * held.EI * held.first_slip * (std::sqrt(1 - 1 / (x * x)) + x * std::asin(1 / x));
      check_close(M, M_exact, {.relative = 5e-4}, "M");
      double lost = 0;
      for (int s = 1; s <= 800; ++s) {
        const auto loss = point.commit(turned({.eps = 1e-4, .chi2 = chi * std::sin(turn * s / 400)}, angle));
        if (s > 400) lost += loss.dissipated;
      }
      const double D = 16 / std::numbers::pi * held.EI * held.first_slip * held.first_slip *
                       (std::sqrt(x * x - 1) - std::acos(1 / x));
      // Near first slip few cells slip; off the grid they are 1.2e-3 away at x = 1.2.
      check_close(lost, D, {.relative = angle == 0 ? 1e-3 : 1.5e-3}, "loss");
    }
  }
}
