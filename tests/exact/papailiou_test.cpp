#include "strandyn/exact/papailiou.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tension = 13.7e3;

PapailiouLayer steel_layer() {
  return {test::steel_1x6(), tension};
}

}  // namespace

TEST_CASE("Papailiou: limit forces and first slip of the 1/6 strand at 13.7 kN") {
  const auto layer = steel_layer();
  // The last digit given.
  check_close(layer.limit_force(pi / 2), 339.2, {.absolute = 0.05});
  check_close(layer.limit_force(-pi / 2), -288.8, {.absolute = 0.05});
  check_close(layer.first_slip(), 0.026367, {.absolute = 5e-7});
  // The limit at constant wire force, F_0 mu |sin a| pi/2.
  const double constant = layer.wire_force() * 0.5 * std::sin(11.8 * pi / 180) * pi / 2;
  check_close(constant, 312.7, {.absolute = 0.05});
}

TEST_CASE("Papailiou: with many wires the moment at full slip is the closed form of full slip") {
  auto strand = test::steel_1x6();
  const double EI_min = conductor::section_constants(strand).EI_min;
  const double M_inf = full_slip(strand, tension).M_inf;
  // The same layer spread over 1200 wires of a 200th of the area each. The kink of the limit at pi/2 makes the sum good
  // to the square of the spacing, 2.7e-5, times a number below one tenth.
  strand.layers[1].wires *= 200;
  strand.layers[1].wire_area /= 200;
  strand.layers[1].wire_inertia /= 200;
  const PapailiouLayer many(strand, tension);
  check_close(many.moment(0.001, 10.0) - EI_min * 10.0, M_inf, {.relative = 2.7e-6});
}

TEST_CASE("Papailiou: the moment is a chain of straight lines between the kinks") {
  const auto layer = steel_layer();
  const double theta_first = 0.2;
  const std::vector<double> kinks = layer.kinks(theta_first);
  REQUIRE(kinks.size() == 6);
  double slope_below = 1e300;
  double from = 0;
  for (const double kink : kinks) {
    const double M_0 = layer.moment(theta_first, from);
    const double M_1 = layer.moment(theta_first, kink);
    // On the line to rounding at its middle, and each line is less steep than the one before.
    check_close(layer.moment(theta_first, (from + kink) / 2), (M_0 + M_1) / 2, {.relative = 1e-13});
    const double slope = (M_1 - M_0) / (kink - from);
    CHECK(slope < slope_below);
    slope_below = slope;
    from = kink;
  }
  const auto constants = conductor::section_constants(test::steel_1x6());
  // The first line is EI_max: six wires evenly around give sum sin^2 = 3 wherever the first is.
  check_close(layer.moment(theta_first, kinks[0]) / kinks[0], constants.EI_max, {.relative = 1e-13});
  check_close(layer.moment(theta_first, 2.0) - layer.moment(theta_first, 1.0), constants.EI_min, {.relative = 1e-11});
}

TEST_CASE("Papailiou: the wire force is continuous where stick meets the limit") {
  const auto layer = steel_layer();
  for (const double theta : {-1.5, -0.3, 0.3, 1.5}) {
    const double chi = layer.slip_curvature(theta);
    check_close(layer.bending_force(theta, chi * (1 - 1e-12)), layer.limit_force(theta), {.relative = 2e-12});
    check_close(layer.bending_force(theta, 2 * chi), layer.limit_force(theta), {});
  }
  check_close(layer.slip_curvature(1e-9), layer.first_slip(), {.relative = 1e-9});
}

TEST_CASE("Papailiou: a wire on the neutral plane carries nothing and has no kink") {
  const auto layer = steel_layer();
  CHECK(layer.kinks(0).size() == 4);
  check_close(layer.bending_force(0, 1.0), 0, {});
}

TEST_CASE("Papailiou: refuses a strand of several layers or with residual forces") {
  CHECK_THROWS_AS(PapailiouLayer(test::curlew(), tension), std::invalid_argument);
  auto strand = test::steel_1x6();
  strand.layers[1].residual_force = 100;
  CHECK_THROWS_AS(PapailiouLayer(strand, tension), std::invalid_argument);
}
