#include "strandyn/exact/elastica.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

CantileverTip unit_cantilever(double load) {
  return cantilever_elastica({.force = load, .EI = 1, .length = 1});
}

struct Place {
  double slope = 0;
  double curvature = 0;
  double x = 0;
  double w = 0;
};

Place rate(const Place& at, double load) {
  return {
      .slope = at.curvature, .curvature = -load * std::cos(at.slope), .x = std::cos(at.slope), .w = std::sin(at.slope)};
}

Place along(const Place& at, const Place& by, double h) {
  return {.slope = at.slope + h * by.slope,
          .curvature = at.curvature + h * by.curvature,
          .x = at.x + h * by.x,
          .w = at.w + h * by.w};
}

/// The other way: EI phi'' = -P cos phi from the free tip back to the clamp, by Runge-Kutta.
Place march_from_tip(double tip_slope, double load) {
  constexpr int steps = 2000;
  const double h = -1.0 / steps;
  Place at{.slope = tip_slope};
  for (int i = 0; i < steps; ++i) {
    const Place k1 = rate(at, load);
    const Place k2 = rate(along(at, k1, h / 2), load);
    const Place k3 = rate(along(at, k2, h / 2), load);
    const Place k4 = rate(along(at, k3, h), load);
    at = along(along(along(along(at, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return at;
}

}  // namespace

TEST_CASE("elastica: tip of a cantilever at P L^2/EI of 1 and 10") {
  // Six decimals are given.
  check_close(unit_cantilever(1).deflection, 0.301721, {.absolute = 5e-7});
  check_close(unit_cantilever(1).shortening, -0.056433, {.absolute = 5e-7});
  check_close(unit_cantilever(10).deflection, 0.810609, {.absolute = 5e-7});
  check_close(unit_cantilever(10).shortening, -0.554996, {.absolute = 5e-7});
}

TEST_CASE("elastica: marching from the tip back arrives at the clamp, flat") {
  for (const double load : {0.1, 1.0, 10.0, 100.0}) {
    const CantileverTip tip = unit_cantilever(load);
    const Place clamp = march_from_tip(tip.slope, load);
    // Fourth order: (sqrt(P)/2000)^4 = 6e-10 at the largest load; an error of the slope grows by exp(sqrt(P)) at most.
    const double allowed = load > 50 ? 2e-6 : 1e-10;
    check_close(clamp.slope, 0, {.absolute = allowed}, "slope at the clamp");
    check_close(-clamp.w, tip.deflection, {.absolute = allowed}, "deflection");
    check_close(-clamp.x, 1 + tip.shortening, {.absolute = allowed}, "reach");
  }
}

TEST_CASE("elastica: a small load bends as the linear beam") {
  const double load = 1e-3;
  const CantileverTip tip = unit_cantilever(load);
  // The series goes on with the square of the load: w = P/3 (1 - 4/35 P^2 ...), slope P/2, u = -P^2/15.
  check_close(tip.deflection, load / 3, {.relative = 1e-6});
  check_close(tip.slope, load / 2, {.relative = 1e-6});
  check_close(tip.shortening, -load * load / 15, {.relative = 1e-6});
  check_close(unit_cantilever(0).deflection, 0, {});
}

TEST_CASE("elastica: a large load turns the beam along itself but for a boundary layer at the clamp") {
  // Semi-infinite elastica: phi falls short of 90 degrees by the layer only; reach sqrt(2/P) L, deflection short of L
  // by (2 - sqrt 2)/sqrt(P) L.
  for (const double load : {1e3, 1e5}) {
    const double root = std::sqrt(load);
    const CantileverTip tip = unit_cantilever(load);
    check_close(1 + tip.shortening, std::numbers::sqrt2 / root, {.relative = 1e-11});
    check_close(1 - tip.deflection, (2 - std::numbers::sqrt2) / root, {.relative = 1e-11});
    CHECK(tip.slope <= std::numbers::pi / 2);
  }
}

TEST_CASE("elastica: only P L^2/EI matters, lengths scale") {
  const CantileverTip tip = cantilever_elastica({.force = 4, .EI = 8, .length = 2});  // P L^2/EI = 2
  check_close(tip.deflection, 2 * unit_cantilever(2).deflection, {.relative = 1e-14});
  check_close(tip.slope, unit_cantilever(2).slope, {.relative = 1e-14});
}
