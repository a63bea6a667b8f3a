#include "strandyn/analysis/energy_balance.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "strandyn/analysis/published_laws.hpp"
#include "strandyn/exact/foti_2018.hpp"
#include "support/check_close.hpp"

using namespace strandyn::air;
using namespace strandyn::analysis;
using strandyn::test::check_close;

namespace {

/// Drake 26/7, diameter 3 x 3.454 mm + 4 x 4.442 mm.
constexpr double drake_diameter = 28.13e-3;
constexpr double drake_mass = 1.628;
constexpr double drake_strength = 140.1e3;
constexpr double frequencies[] = {10, 15, 20, 30, 40, 50};

Wind drake_wind(double turbulence_intensity = 0) {
  return {.curve = cigre_cubic(), .diameter = drake_diameter, .turbulence_intensity = turbulence_intensity};
}

SelfDamping noiseux(double tension) {
  const RatedConductor drake{
      .diameter = drake_diameter, .mass_per_length = drake_mass, .rated_strength = drake_strength};
  for (const PublishedLaw& law : published_laws()) {
    if (const auto factored = law_for(law, drake)) {
      return [law = *factored, tension](const Vibration& v) {
        return power(law, {.antinode_amplitude = v.antinode_amplitude, .frequency = v.frequency, .tension = tension});
      };
    }
  }
  FAIL("no published law with a factor");
  return {};
}

SelfDamping foti(double tension) {
  return [conductor = strandyn::exact::Foti2018{
              .EI = 1444, .chi_0 = 0.01927, .mass_per_length = drake_mass, .tension = tension}](const Vibration& v) {
    return self_damping(conductor, {.antinode_amplitude = v.antinode_amplitude, .frequency = v.frequency});
  };
}

/// Linear viscous damping along the span: P = c (2 pi f A)^2/4.
SelfDamping viscous(double c) {
  return [c](const Vibration& v) {
    return c * std::pow(2 * std::numbers::pi * v.frequency * v.antinode_amplitude, 2) / 4;
  };
}

/// The reference values reach below the range of the cubic, so it is followed down to 0.01.
constexpr BalanceOptions down_to_001{.lowest = 0.01};

}  // namespace

TEST_CASE("energy balance: bare Drake with the exponents of Noiseux") {
  const double reference[] = {0.829, 0.555, 0.291, 0.0837, 0.0458, 0.0322};
  for (int i = 0; i < 6; ++i) {
    const Balance b = energy_balance(drake_wind(), frequencies[i], noiseux(28e3), down_to_001);
    CHECK(b.ending == BalanceEnding::balanced);
    check_close(b.amplitude_over_diameter, reference[i], {.relative = 0.01});
    // All digits of the reference come out at 20 % of the rated strength, 28.02 kN.
    const Balance rated = energy_balance(drake_wind(), frequencies[i], noiseux(0.2 * drake_strength), down_to_001);
    check_close(rated.amplitude_over_diameter, reference[i], {.absolute = i < 3 ? 5e-4 : 5e-5});
    CHECK(b.within_curve == (i < 4));
  }
}

TEST_CASE("energy balance: bare Drake with the law of Foti and Martinelli 2018") {
  const double reference[] = {0.610, 0.239, 0.104, 0.0418, 0.0257, 0.0183};
  for (int i = 0; i < 6; ++i) {
    const Balance b = energy_balance(drake_wind(), frequencies[i], foti(28e3), down_to_001);
    CHECK(b.ending == BalanceEnding::balanced);
    check_close(b.amplitude_over_diameter, reference[i], {.relative = 0.01});
    const Balance rated = energy_balance(drake_wind(), frequencies[i], foti(0.2 * drake_strength), down_to_001);
    check_close(rated.amplitude_over_diameter, reference[i], {.absolute = i < 3 ? 5e-4 : 5e-5});
  }
}

TEST_CASE("energy balance: with peak to peak read as amplitude the reference values do not come out") {
  const SelfDamping law = noiseux(28e3);
  const SelfDamping halved = [&](Vibration v) {
    v.antinode_amplitude /= 2;
    return law(v);
  };
  const Balance b = energy_balance(drake_wind(), 20, halved, down_to_001);
  CHECK(b.amplitude_over_diameter > 2 * 0.291);
}

TEST_CASE("energy balance: viscous damping against the cubic is a root of a cubic") {
  const double f = 20, D = drake_diameter, c = 0.1;
  const Balance b = energy_balance(drake_wind(), f, viscous(c));
  // f^3 D^4 (c3 a^3 + c2 a^2 + c1 a + c0) = c pi^2 f^2 D^2 a^2 at the amplitude found.
  const double a = b.amplitude_over_diameter;
  const double square = 101.62 - c * std::pow(std::numbers::pi, 2) / (f * D * D);
  check_close(-99.73 * a * a * a + square * a * a + 0.1627 * a + 0.2256, 0, {.absolute = 1e-9});
  check_close(b.antinode_amplitude, a * D, {.relative = 1e-14});
  check_close(b.antinode_velocity, 2 * std::numbers::pi * f * a * D, {.relative = 1e-14});
  check_close(b.power, viscous(c)({.antinode_amplitude = a * D, .frequency = f}), {.relative = 1e-9});
  CHECK(b.crossings == 1);
  CHECK(b.from_lowest);
}

TEST_CASE("energy balance: turbulence lowers the amplitude to that of a stronger damping") {
  const SelfDamping law = viscous(0.1);
  const SelfDamping stronger = viscous(0.1 / turbulence_factor(0.1));
  const Balance gusty = energy_balance(drake_wind(0.1), 20, law);
  check_close(gusty.amplitude_over_diameter, energy_balance(drake_wind(), 20, stronger).amplitude_over_diameter,
              {.relative = 1e-11});
  CHECK(gusty.amplitude_over_diameter < energy_balance(drake_wind(), 20, law).amplitude_over_diameter);
}

TEST_CASE("energy balance: damping above the wind everywhere is no crossing") {
  const Balance b = energy_balance({.curve = diana_falco(), .diameter = 0.03}, 20, viscous(1000));
  CHECK(b.ending == BalanceEnding::damping_stronger);
  CHECK(b.amplitude_over_diameter == 0.0);
  CHECK(b.crossings == 0);
}

TEST_CASE("energy balance: without damping the wind is the stronger at the largest amplitude") {
  for (const WindPowerCurve* curve : wind_power_curves()) {
    const Balance b = energy_balance({.curve = *curve, .diameter = 0.03}, 20, [](const Vibration&) { return 0.0; });
    CHECK(b.ending == BalanceEnding::wind_stronger);
  }
}

TEST_CASE("energy balance: friction that begins at a slip amplitude stops vibration there or beyond") {
  // Nothing below 6 mm, then steep.
  const SelfDamping slip = [](const Vibration& v) {
    return v.antinode_amplitude < 6e-3 ? 0 : 1e6 * (v.antinode_amplitude - 6e-3);
  };
  const Balance b = energy_balance(drake_wind(), 20, slip);
  CHECK(b.ending == BalanceEnding::balanced);
  CHECK(b.antinode_amplitude > 6e-3);
  check_close(b.antinode_amplitude, 6e-3, {.relative = 1e-3});
}

TEST_CASE("energy balance: where damping wins at small amplitudes a push is needed and this is said") {
  // A power linear in A, more than the wind below A/D = 0.2 and above 0.816: two crossings, one of them stable.
  const Wind wind = drake_wind();
  const double slope = wind_power(wind, {.antinode_amplitude = 0.2 * drake_diameter, .frequency = 20}) / 0.2;
  const SelfDamping linear = [&](const Vibration& v) { return slope * v.antinode_amplitude / drake_diameter; };
  const Balance b = energy_balance(wind, 20, linear);
  CHECK(b.ending == BalanceEnding::balanced);
  CHECK(b.crossings == 1);
  CHECK_FALSE(b.from_lowest);
  CHECK(b.amplitude_over_diameter > 0.5);
}

TEST_CASE("energy balance: of two stable amplitudes the smaller is given and both are counted") {
  const Wind wind = drake_wind();
  const SelfDamping woven = [&](const Vibration& v) {
    const double a = v.antinode_amplitude / drake_diameter;
    return wind_power(wind, v) * (1 + (a - 0.1) * (a - 0.2) * (a - 0.4));  // stable at 0.1 and at 0.4
  };
  const Balance b = energy_balance(wind, 20, woven);
  CHECK(b.crossings == 2);
  check_close(b.amplitude_over_diameter, 0.1, {.relative = 1e-11});
  CHECK(b.from_lowest);
}

TEST_CASE("energy balance: a power that is no number ends without an amplitude") {
  const SelfDamping broken = [](const Vibration& v) {
    return v.antinode_amplitude > 0.01 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  };
  const Balance b = energy_balance(drake_wind(), 20, broken);
  CHECK(b.ending == BalanceEnding::undefined);
  CHECK(b.amplitude_over_diameter == 0.0);
}

TEST_CASE("energy balance: each ending says what happened in its own words") {
  CHECK(describe(BalanceEnding::balanced).find("equals") != std::string_view::npos);
  CHECK(describe(BalanceEnding::damping_stronger).find("smallest") != std::string_view::npos);
  CHECK(describe(BalanceEnding::wind_stronger).find("largest") != std::string_view::npos);
  CHECK(describe(BalanceEnding::undefined).find("finite") != std::string_view::npos);
}
