#include "strandyn/exact/tensioned_beam.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;

/// Unit length, mass and EI: xi = sqrt(T), omega = p r.
TensionedBeam unit_beam(double xi) {
  return {.tension = xi * xi, .EI = 1, .mass_per_length = 1, .length = 1};
}

double over_string(BeamEnds ends, double xi, int n) {
  return TensionedBeamMode(unit_beam(xi), ends, n).frequency() / (n * xi / 2);
}

}  // namespace

TEST_CASE("tensioned beam: clamped frequencies over the string's at xi = 50") {
  // Five decimals are given.
  check_close(over_string(BeamEnds::clamped, 50, 1), 1.04374, {.absolute = 5e-6});
  check_close(over_string(BeamEnds::clamped, 50, 2), 1.04993, {.absolute = 5e-6});
  check_close(over_string(BeamEnds::clamped, 50, 3), 1.06016, {.absolute = 5e-6});
  check_close(over_string(BeamEnds::clamped, 50, 5), 1.09213, {.absolute = 5e-6});
}

TEST_CASE("tensioned beam: without tension it is the plain beam") {
  const auto first = TensionedBeamMode(unit_beam(0), BeamEnds::clamped, 1);
  check_close(first.wavenumber(), 4.7300407448627040, {.relative = 1e-15});  // cos x cosh x = 1, literature
  check_close(2 * pi * TensionedBeamMode(unit_beam(0), BeamEnds::pinned, 3).frequency(), 9 * pi * pi,
              {.relative = 1e-15});
}

TEST_CASE("tensioned beam: pinned frequencies follow the closed form") {
  for (const double xi : {1.0, 50.0, 1e4}) {
    for (const int n : {1, 7}) {
      check_close(over_string(BeamEnds::pinned, xi, n), std::sqrt(1 + std::pow(n * pi / xi, 2)), {.relative = 1e-15});
    }
  }
}

TEST_CASE("tensioned beam: a slack bending stiffness shortens the clamped string by 1/xi at each end") {
  for (const double xi : {1e3, 1e4}) {
    // f/f_string = 1 + 2/xi + (4 + (n pi)^2/2)/xi^2 + O(xi^-3), by inserting the series in the equation.
    for (const int n : {1, 4}) {
      const double series = 1 + 2 / xi + (4 + std::pow(n * pi, 2) / 2) / (xi * xi);
      check_close(over_string(BeamEnds::clamped, xi, n), series, {.absolute = 500 / (xi * xi * xi)});
    }
  }
}

TEST_CASE("tensioned beam: frequencies rise with the mode and clamping raises them, for every tension") {
  for (const double xi : {0.0, 1e-3, 1.0, 30.0, 1e3, 1e4}) {
    double below = 0;
    for (int n = 1; n <= 200; ++n) {
      CAPTURE(xi);
      CAPTURE(n);
      const double clamped = TensionedBeamMode(unit_beam(xi), BeamEnds::clamped, n).frequency();
      CHECK(clamped > below);
      CHECK(clamped > TensionedBeamMode(unit_beam(xi), BeamEnds::pinned, n).frequency());
      below = clamped;
    }
  }
}

TEST_CASE("tensioned beam: a clamped shape is zero and flat at both ends, its largest antinode is 1") {
  for (const double xi : {0.0, 5.0, 50.0, 1e3, 1e4}) {
    for (const int n : {1, 2, 3, 12, 75}) {
      CAPTURE(xi);
      CAPTURE(n);
      const TensionedBeamMode mode(unit_beam(xi), BeamEnds::clamped, n);
      const double p = std::hypot(xi, mode.wavenumber());
      for (const double x : {0.0, 1.0}) {
        // A rounding of r is a rounding of the end value, and p times that in the slope.
        check_close(mode.at(x).value, 0, {.absolute = 1e-15 * mode.wavenumber()}, "end value");
        check_close(mode.at(x).slope, 0, {.absolute = 2e-15 * p * mode.wavenumber()}, "end slope");
      }
      double largest = 0;
      constexpr int samples = 40000;  // 533 per half wave at n = 75: a parabola's top is met to (pi/1066)^2/2 = 4e-6
      for (int i = 0; i <= samples; ++i) {
        largest = std::max(largest, std::abs(mode.at(static_cast<double>(i) / samples).value));
      }
      check_close(largest, 1, {.absolute = 5e-6}, "antinode");
      CHECK(largest <= 1 + 1e-14);
      CHECK(mode.at(0.4 / n).value > 0);
    }
  }
}

TEST_CASE("tensioned beam: the shape's derivatives are its difference quotients and satisfy the field equation") {
  for (const BeamEnds ends : {BeamEnds::clamped, BeamEnds::pinned}) {
    for (const double xi : {0.0, 20.0}) {
      for (const int n : {1, 2, 5}) {
        const TensionedBeamMode mode(unit_beam(xi), ends, n);
        const double omega = 2 * pi * mode.frequency();
        const double k = std::hypot(xi, mode.wavenumber());
        for (const double x : {0.02, 0.3, 0.5, 0.77}) {
          const double h = 1e-4;
          const auto left = mode.at(x - h);
          const auto mid = mode.at(x);
          const auto right = mode.at(x + h);
          // Central differences: h^2/6 times the third derivative, k^3 at most; k^2 further on, k^5 and k^6.
          check_close((right.value - left.value) / (2 * h), mid.slope, {.absolute = h * h * k * k * k}, "slope");
          check_close((right.slope - left.slope) / (2 * h), mid.curvature, {.absolute = h * h * std::pow(k, 4)},
                      "curvature");
          const double fourth = (right.curvature - 2 * mid.curvature + left.curvature) / (h * h);
          check_close(fourth - xi * xi * mid.curvature, omega * omega * mid.value,
                      {.absolute = h * h * std::pow(k, 6) + 1e-15 * k * k / (h * h)}, "field equation");
        }
      }
    }
  }
}
