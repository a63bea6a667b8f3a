// A damped span in the wind, run until it is steady, against the closed balance of wind and damper.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "strandyn/air/wind_power.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/self_damping/protection.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using std::numbers::pi;
using test::check_close;

namespace {

constexpr double length = 100, tension = 28e3;  // [m], [N]
const std::string drake = "[conductor]\ncatalogue = \"drake\"\n[section]\nlaw = \"stick\"\n";

/// What one damper takes on a span whose wires lose nothing themselves.
self_damping::Protection protection() {
  const casefile::Scene scene = casefile::read_scene_text(
      drake + fmt::format("[analysis]\ntype = \"self-damping\"\nmethod = \"foti-2018\"\nfrequencies_Hz = [20]\n"
                          "amplitude_over_diameter = [0.1]\ntensions_kN = {}\n"
                          "[[analysis.energy_balance]]\nwind = \"diana-falco\"\nself_damping = \"foti-2018\"\n"
                          "span_m = {}\ndamper = [ {{ at_m = 1.0, catalogue = \"z5\" }} ]\n",
                          tension / 1000, length),
      "balance.toml");
  return {scene, scene.as<casefile::SelfDampingAnalysis>().energy_balances.front()};
}

struct Crossing {
  double amplitude = 0;  // [m]
  double power = 0;      // [W] of the damper
  double gain = 0;       // [-] of the damper's power over that of the wind at a given amplitude, relative changes
};

/// The amplitude at which the damper takes what the curve gives: below it takes less.
Crossing balance(double frequency, double diameter) {
  const self_damping::Protection dampers = protection();
  const air::Wind wind{.curve = air::diana_falco(), .diameter = diameter};
  const auto given = [&](double A) {
    return length * air::wind_power(wind, {.antinode_amplitude = A, .frequency = frequency});
  };
  const auto taken = [&](double A) {
    return dampers.at({.antinode_amplitude = A, .frequency = frequency}, tension).power;
  };
  double low = wind.curve.lowest * diameter, high = 0.3 * diameter;
  REQUIRE(given(low) > taken(low));
  REQUIRE(given(high) < taken(high));
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (given(middle) > taken(middle) ? low : high) = middle;
  }
  const double slope = std::log(given(1.01 * low) / given(low)) / std::log(1.01);
  return {.amplitude = low, .power = taken(low), .gain = 2 / (2 - slope)};
}

nlohmann::ordered_json in_time(int mode, double antinode_velocity, int cycles) {
  return test::run(casefile::read_scene_text(
                       drake + fmt::format("[span]\nlength_m = {}\ntension_kN = {}\nelements = 240\n"
                                           "[[wind]]\nmodel = \"power-curve\"\nmode = {}\ncurve = \"diana-falco\"\n"
                                           "[[damper]]\nat_m = 1.0\ncatalogue = \"z5\"\nelements = 3\n"
                                           "[initial]\nvelocity_mode = {}\nantinode_velocity_m_per_s = {}\n"
                                           "[integrator]\nmethod = \"generalized-alpha\"\nrho_inf = 0.9\n"
                                           "steps_per_cycle = 60\n[analysis]\ntype = \"forced\"\ncycles = {}\n",
                                           length, tension / 1000, mode, mode, antinode_velocity, cycles),
                       "span.toml"))
      .summary;
}

}  // namespace

TEST_CASE("damped span in the wind: amplitude and power of the damper in time are those of the balance within 5 %" *
          doctest::test_suite("slow")) {
  for (const int mode : {40, 36, 32}) {
    CAPTURE(mode);
    const auto first = in_time(mode, 0.1, 1);
    const double frequency = first["wind"]["frequency_Hz"], diameter = first["wind"]["diameter_m"];
    const Crossing expected = balance(frequency, diameter);
    // Modes that the damper hardly moves, woken by the start, die out slowly: the more the further off it is.
    const auto s = in_time(mode, 2 * pi * frequency * expected.amplitude, 600)["steady"];
    MESSAGE(fmt::format("{:.2f} Hz: A/D {:.5f} in time, {:.5f} of the balance; damper {:.4f} W, {:.4f} W; gain {:.2f}",
                        frequency, s["antinode_amplitude_m"].get<double>() / diameter, expected.amplitude / diameter,
                        s["dampers_W"].get<double>(), expected.power, expected.gain));
    check_close(s["antinode_amplitude_m"], expected.amplitude, {.relative = 0.05});
    check_close(s["dampers_W"], expected.power, {.relative = 0.05});
    // Both curves rise nearly alike: what the wind gives at an amplitude agrees this much better.
    CHECK(std::abs(s["dampers_W"].get<double>() / expected.power - 1) / expected.gain < 0.015);
    check_close(s["work_in_over_lost"], 1, {.relative = 0.01});
    CHECK(s["numerical_share"] < 0.01);
  }
}
