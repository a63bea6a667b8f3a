#include "strandyn/exact/taut_string.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::exact;
using strandyn::test::check_close;

TEST_CASE("taut string: mode n fits n half waves of the wave speed into the span") {
  const TautString string{.tension = 18e3, .mass_per_length = 2, .length = 30};
  // 9000 m^2/s^2 under the root, by hand.
  check_close(wave_speed(string), 94.86832980505139, {.relative = 1e-15});
  check_close(frequency(string, 1), 1.5811388300841898, {.relative = 1e-15});
  check_close(frequency(string, 12), 18.973665961010276, {.relative = 1e-15});
}

TEST_CASE("sagged cable: first symmetric frequency over the taut string's") {
  // Six decimals are given.
  check_close(first_symmetric_ratio(0), 1, {});
  check_close(first_symmetric_ratio(1), 1.040200, {.absolute = 5e-7});
  check_close(first_symmetric_ratio(10), 1.345125, {.absolute = 5e-7});
  check_close(first_symmetric_ratio(std::numeric_limits<double>::infinity()), 2.860593, {.absolute = 5e-7});
}

TEST_CASE("sagged cable: the first symmetric frequency meets the antisymmetric one at 4 pi^2") {
  constexpr double pi = std::numbers::pi;
  check_close(first_symmetric_ratio(4 * pi * pi), 2, {.relative = 1e-15});
}

TEST_CASE("sagged cable: a nearly taut one gains lambda^2 4/pi^4") {
  // v = pi/2 + delta in the equation: delta = lambda^2/(4 (pi/2)^3) to first order, ratio 1 + 2 delta/pi.
  const double lambda_squared = 1e-4;
  const double gain = 4 * lambda_squared / std::pow(std::numbers::pi, 4);
  check_close(first_symmetric_ratio(lambda_squared), 1 + gain, {.absolute = gain * lambda_squared});
}

TEST_CASE("sagged cable: Irvine's parameter is weight against stretch") {
  // wL/H = 0.2, L_e/L = 1.005: 0.04 * 1000/1.005.
  const SaggedCable cable{.horizontal_tension = 10e3, .weight_per_length = 20, .EA = 1e7, .length = 100};
  check_close(irvine_parameter(cable), 40 / 1.005, {.relative = 1e-15});
}
