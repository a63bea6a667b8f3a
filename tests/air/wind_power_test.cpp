#include "strandyn/air/wind_power.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::air;
using strandyn::test::check_close;

namespace {

struct Deviation {
  double largest = 0;  // relative
  double at = 0;       // A/D
};

Deviation from_table(const WindPowerCurve& curve, double from = 0) {
  Deviation d;
  for (const WindTableRow& row : curve.table) {
    const double relative = std::abs(curve.at(row.a) / row.fnc - 1);
    if (row.a >= from && relative > d.largest) d = {.largest = relative, .at = row.a};
  }
  return d;
}

}  // namespace

TEST_CASE("wind power: Diana and Falco stay within 11.6 percent of their table") {
  CHECK(diana_falco().table.size() == 10);
  check_close(from_table(diana_falco()).largest, 0.11554, {.absolute = 1e-5});
  CHECK(from_table(diana_falco()).at == 0.03);
  check_close(from_table(diana_falco(), 0.05).largest, 0.08270, {.absolute = 1e-5});
}

TEST_CASE("wind power: Brika and Laneville stay within 11.3 percent of their table") {
  CHECK(brika_laneville().table.size() == 7);
  check_close(from_table(brika_laneville()).largest, 0.11276, {.absolute = 1e-5});
  CHECK(from_table(brika_laneville()).at == 0.03);
  check_close(from_table(brika_laneville(), 0.05).largest, 0.05412, {.absolute = 1e-5});
  // The copy with the other sign of the seventh coefficient misses the last row by a factor of 38.
  WindPowerCurve wrong = brika_laneville();
  wrong.coefficients[7] = -wrong.coefficients[7];
  CHECK(wrong.at(0.4) > 30 * 6.0);
}

TEST_CASE("wind power: the CIGRE cubic lies between the two measured curves from 0.1 on and ends at 1.02") {
  for (const double a : {0.1, 0.2, 0.3}) {
    CHECK(cigre_cubic().at(a) < diana_falco().at(a));
    CHECK(cigre_cubic().at(a) > brika_laneville().at(a));
  }
  check_close(cigre_cubic().at(0.2), -99.73 * 0.008 + 101.62 * 0.04 + 0.1627 * 0.2 + 0.2256, {.relative = 1e-14});
  CHECK(cigre_cubic().at(1.02) > 0);
  CHECK(cigre_cubic().at(1.03) < 0);
}

TEST_CASE("wind power: every curve is positive in its range") {
  CHECK(wind_power_curves().size() == 3);
  for (const WindPowerCurve* curve : wind_power_curves()) {
    double smallest = 1e9;
    for (int i = 0; i <= 1000; ++i) {
      smallest = std::min(smallest, curve->at(curve->lowest + (curve->highest - curve->lowest) * i / 1000));
    }
    CHECK_MESSAGE(smallest > 0, curve->name);
  }
}

TEST_CASE("wind power: power per length is the cube of frequency and the fourth power of diameter") {
  const Wind wind{.curve = cigre_cubic(), .diameter = 0.03};
  const double P = wind_power(wind, {.antinode_amplitude = 0.006, .frequency = 20});
  check_close(P, 8000 * 81e-8 * cigre_cubic().at(0.2), {.relative = 1e-13});
  const Wind larger{.curve = cigre_cubic(), .diameter = 0.06};
  check_close(wind_power(larger, {.antinode_amplitude = 0.012, .frequency = 40}), 128 * P, {.relative = 1e-13});
}

TEST_CASE("wind power: turbulence takes nothing at zero and leaves its reciprocal when strong") {
  CHECK(turbulence_factor(0) == 1.0);
  check_close(turbulence_factor(0.09), 1 / std::sqrt(2.0), {.relative = 1e-15});
  check_close(turbulence_factor(90), 1e-3, {.relative = 1e-6});
  const Vibration vibration{.antinode_amplitude = 0.006, .frequency = 20};
  const Wind steady{.curve = cigre_cubic(), .diameter = 0.03};
  const Wind gusty{.curve = cigre_cubic(), .diameter = 0.03, .turbulence_intensity = 0.12};
  check_close(wind_power(gusty, vibration), 0.6 * wind_power(steady, vibration), {.relative = 1e-14});  // 3-4-5
}

TEST_CASE("wind power: vortices shed at a fifth of speed over diameter") {
  check_close(shedding_frequency({.diameter = 0.02813}, 4), 0.8 / 0.02813, {.relative = 1e-14});
  check_close(
      wind_speed({.diameter = 0.03, .strouhal = 0.185}, shedding_frequency({.diameter = 0.03, .strouhal = 0.185}, 5)),
      5, {.relative = 1e-14});
}
