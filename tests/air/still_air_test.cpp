#include "strandyn/air/still_air.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn;
using air::AirForce;
using air::StillAir;
using test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double diameter = 31.65e-3;  // [m] Curlew

/// Mean of a function over a turn.
template <class F>
double mean_over_turn(const F& f) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += f(2 * pi * (i + 0.5) / steps);
  return sum / steps;
}

}  // namespace

TEST_CASE("air: the attached flow is that of the drag coefficient of Stokes and Wang") {
  const StillAir air;
  for (const double frequency : {5.0, 20.0, 100.0}) {
    for (const double amplitude : {1e-3, 5e-3}) {
      // F = rho D C_d/2 U^2 |cos| cos, C_d = 3 pi^3/(2 K)(s + s^2 - s^3/4): its mean power against that of c V^2/2.
      const double velocity = 2 * pi * frequency * amplitude;
      const double s = 1 / std::sqrt(pi * diameter * diameter * frequency / air.viscosity);
      const double K = 2 * pi * amplitude / diameter;
      const double Cd = 3 * pi * pi * pi / (2 * K) * (s + s * s - s * s * s / 4);
      const double power = air.density * diameter * Cd / 2 * std::pow(velocity, 3) * 4 / (3 * pi);
      check_close(air::attached_flow(air, diameter, frequency) * velocity * velocity / 2, power, {.relative = 1e-12});
      check_close(air::force_at(air, diameter, frequency).power_of_sine(velocity), power, {.relative = 1e-12});
    }
  }
}

TEST_CASE("air: the power of a loop goes with the square of amplitude and with f^2.5 as viscosity vanishes") {
  const auto power = [](double viscosity, double amplitude, double frequency) {
    return air::force_at({.viscosity = viscosity}, diameter, frequency).power_of_loop(2 * pi * frequency * amplitude);
  };
  const double at = power(1e-13, 1e-3, 20);
  check_close(std::log2(power(1e-13, 1e-3, 40) / at), 2.5, {.absolute = 1e-6});
  check_close(std::log2(power(1e-13, 2e-3, 20) / at), 2, {.absolute = 1e-12});
  CHECK(std::log2(power(1.5e-5, 1e-3, 40) / power(1.5e-5, 1e-3, 20)) < 2.5);
}

TEST_CASE("air: means over a sine and over a loop are those of the force") {
  const AirForce force{.linear = 0.02, .quadratic = 0.3, .cubic = 0.7};
  const double V = 0.4;
  const auto power = [&](double w) { return force.factor(std::abs(w)) * w * w; };
  check_close(force.power_of_sine(V), mean_over_turn([&](double a) { return power(V * std::cos(a)); }),
              {.relative = 1e-9});
  check_close(force.power_of_loop(V),
              mean_over_turn([&](double x) { return force.power_of_sine(V * std::abs(std::sin(x))); }),
              {.relative = 1e-8});
}

TEST_CASE("air: the cubic force takes what a drag coefficient in proportion to K takes") {
  const StillAir air{.drag_per_K = 0.2};
  const double frequency = 20, amplitude = 6e-3;
  const double velocity = 2 * pi * frequency * amplitude;
  const AirForce force = air::force_at(air, diameter, frequency);
  const double Cd = 0.2 * 2 * pi * amplitude / diameter;
  const double expected = mean_over_turn([&](double a) {
    const double w = velocity * std::cos(a);
    return air.density * diameter * Cd / 2 * std::abs(w) * w * w;
  });
  check_close(AirForce{.cubic = force.cubic}.power_of_sine(velocity), expected, {.relative = 1e-8});
}

TEST_CASE("air: figures of the literature and of other tables") {
  const StillAir air;
  // A loop of Curlew at 0.2 m/s in mW/m, worked out elsewhere to three digits.
  for (const auto& [frequency, milliwatts] : {std::pair{10.0, 0.0532}, {20.0, 0.0747}, {50.0, 0.118}}) {
    check_close(1e3 * air::force_at(air, diameter, frequency).power_of_loop(0.2), milliwatts, {.relative = 6e-3});
  }
  // Hall's limit at beta = 1300: 5.778/6.005 (1 + 0.205/6.005).
  check_close(air::honji_limit(air, diameter, 1300 * air.viscosity / (diameter * diameter)), 0.996, {.absolute = 5e-3});
  CHECK(air::force_at({.density = 0}, diameter, 20).is_none());
}
