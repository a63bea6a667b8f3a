#include "strandyn/analysis/bending_amplitude.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "strandyn/exact/tensioned_beam.hpp"
#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::exact::BeamEnds;
using strandyn::exact::TensionedBeamMode;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr SurfaceWire aluminium{.diameter = 4.442e-3, .young = 68e9};
constexpr ClampedEnd drake{.tension = 28e3, .EI_min = 27};  // all wires slip

}  // namespace

TEST_CASE("bending amplitude: Poffenberger and Swart as printed") {
  const double p = std::sqrt(28e3 / 27), x = 0.089;
  const double K = 4.442e-3 * 68e9 * p * p / 4 / (std::exp(-p * x) - 1 + p * x);
  check_close(stress_per_bending_amplitude(drake, aluminium), K, {.relative = 1e-13});
  check_close(bending_stress(drake, aluminium, 1e-4), 1e-4 * K, {.relative = 1e-13});
}

TEST_CASE("bending amplitude: a stiff end is a cantilever and a limp one is a string") {
  const double x = 0.089;
  // Uniform curvature 2 y/x^2 with y = Y_b/2: stress E d/2 . Y_b/x^2; the next term is p x/3.
  const ClampedEnd stiff{.tension = 1, .EI_min = 1e10};
  check_close(stress_per_bending_amplitude(stiff, aluminium), 68e9 * 4.442e-3 / (2 * x * x), {.relative = 1e-6});
  const ClampedEnd limp{.tension = 28e3, .EI_min = 1e-9};
  const double p = std::sqrt(28e3 / 1e-9);
  check_close(stress_per_bending_amplitude(limp, aluminium), 68e9 * 4.442e-3 * p / (4 * x),
              {.relative = 1.1 / (p * x)});
}

TEST_CASE("bending amplitude: the series for small arguments joins the closed form") {
  // p x = 0.03 is where they meet; the values at both sides differ by the slope, 1/3 of the step.
  const auto K_at = [](double z) {
    const double p = z / 0.089;
    return stress_per_bending_amplitude({.tension = p * p * 1e6, .EI_min = 1e6}, aluminium);
  };
  check_close(K_at(0.03 * (1 + 1e-9)) / K_at(0.03 * (1 - 1e-9)), 1, {.absolute = 5e-11});
}

TEST_CASE("bending amplitude: a limp conductor moves as the sine of its loop") {
  const double Y_b =
      bending_amplitude({.tension = 28e3, .EI_min = 1e-12}, {.antinode_amplitude = 5e-3, .loop_length = 3.3});
  check_close(Y_b, 2 * 5e-3 * std::sin(pi * 0.089 / 3.3), {.relative = 1e-5});  // 1/(p x) is 2e-7/0.089
}

TEST_CASE("bending amplitude: in a long loop the end bends as under a static deflection") {
  const double loop = 300, k = pi / loop, p = std::sqrt(28e3 / 27), x = 0.089;
  const double Y_b = bending_amplitude(drake, {.antinode_amplitude = 1, .loop_length = loop});
  // Left out: (k/p)^2 and (k x)^2, below 1e-6.
  check_close(Y_b, 2 * k * (x - (1 - std::exp(-p * x)) / p), {.relative = 1e-6});
}

TEST_CASE("bending amplitude: the end of the exact mode of a clamped beam") {
  // Mode 12 of 30 m; each end knows nothing of the other (exp(-p L) vanishes).
  for (const double EI : {27.0, 200.0, 1500.0}) {
    const TensionedBeamMode mode({.tension = 28e3, .EI = EI, .mass_per_length = 1.628, .length = 30}, BeamEnds::clamped,
                                 12);
    const ClampedEnd end{.tension = 28e3, .EI_min = EI};
    const double Y = 4e-3;
    const double Y_b = bending_amplitude(end, {.antinode_amplitude = Y, .loop_length = pi / mode.wavenumber()});
    // The near field reaches the first antinode, which is the largest: measured 4e-4 at EI = 1500, 1e-14 at 27.
    check_close(Y_b, 2 * Y * mode.at(0.089).value, {.relative = 1e-3});
  }
}

TEST_CASE("bending amplitude: the stress of Poffenberger and Swart is that of the exact end in long loops") {
  const TensionedBeamMode mode({.tension = 28e3, .EI = 27, .mass_per_length = 1.628, .length = 30}, BeamEnds::clamped,
                               6);
  const double Y = 4e-3, k = mode.wavenumber();
  const double Y_b = bending_amplitude(drake, {.antinode_amplitude = Y, .loop_length = pi / k});
  const double exact = aluminium.young * aluminium.diameter / 2 * Y * mode.at(0).curvature;
  // The static shape leaves out (k x)^2/6 = 5e-4.
  check_close(bending_stress(drake, aluminium, Y_b), exact, {.relative = std::pow(k * 0.089, 2) / 6});
}
