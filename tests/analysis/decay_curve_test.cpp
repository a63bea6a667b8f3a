#include "strandyn/analysis/decay_curve.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr SpanNumbers span{.frequency = 25, .length = 40, .mass_per_length = 2};

/// [J] of a sine of this antinode amplitude on the whole span.
double energy(double amplitude) {
  return span.mass_per_length * span.length * std::pow(2 * pi * span.frequency * amplitude, 2) / 4;
}

}  // namespace

TEST_CASE("decay curve: of a viscous decay the decrement is that of every cycle, and the two loss factors agree") {
  constexpr double delta = 0.02;
  std::vector<DecayingCycle> cycles;
  for (int i = 0; i < 30; ++i) {
    const double amplitude = 5e-3 * std::exp(-delta * i);
    // A cycle takes the energy from half a cycle before to half a cycle after its middle.
    cycles.push_back({.number = i + 1.0, .amplitude = amplitude, .lost = 2 * std::sinh(delta) * energy(amplitude)});
  }
  const auto curve = damping_against_amplitude(cycles, span);
  REQUIRE(curve.size() == 30);
  for (const DampingAtAmplitude& at : curve) {
    check_close(at.log_decrement, delta, {.relative = 1e-12});
    check_close(at.loss_factor, std::sinh(delta) / pi, {.relative = 1e-12});
    check_close(at.damping_ratio, at.loss_factor / 2, {.relative = 1e-14});
    check_close(at.power, 2 * std::sinh(delta) * energy(at.amplitude) * span.frequency / span.length,
                {.relative = 1e-12});
  }
  check_close(exponent_of_amplitude(curve).value(), 2, {.relative = 1e-12});
}

TEST_CASE("decay curve: where the loss goes with a power of the amplitude, the exponent is that power") {
  std::vector<DecayingCycle> cycles;
  for (int i = 0; i < 20; ++i) {
    const double amplitude = 5e-3 / (1 + 0.1 * i);
    cycles.push_back({.number = i + 1.0, .amplitude = amplitude, .lost = 40 * std::pow(amplitude, 3.3)});
  }
  check_close(exponent_of_amplitude(damping_against_amplitude(cycles, span)).value(), 3.3, {.relative = 1e-11});
}

TEST_CASE("decay curve: cycles that were left out are counted in the decrement") {
  const std::vector<DecayingCycle> cycles = {
      {.number = 1, .amplitude = 1}, {.number = 2, .amplitude = 0.9}, {.number = 12, .amplitude = 0.5}};
  const auto curve = damping_against_amplitude(cycles, span);
  check_close(curve[0].log_decrement, std::log(1 / 0.9), {.relative = 1e-14});
  check_close(curve[1].log_decrement, std::log(1 / 0.5) / 11, {.relative = 1e-14});
  check_close(curve[2].log_decrement, std::log(0.9 / 0.5) / 10, {.relative = 1e-14});
}

TEST_CASE("decay curve: without loss, without range or at rest there is no exponent") {
  CHECK(damping_against_amplitude({}, span).empty());
  CHECK(damping_against_amplitude({{.number = 1, .amplitude = 0, .lost = 0}}, span).empty());
  std::vector<DecayingCycle> cycles;
  for (int i = 0; i < 9; ++i) cycles.push_back({.number = i + 1.0, .amplitude = 1 - 0.1 * i, .lost = 0});
  CHECK_FALSE(exponent_of_amplitude(damping_against_amplitude(cycles, span)).has_value());
  for (DecayingCycle& cycle : cycles) cycle.amplitude = 1, cycle.lost = 0.1;
  CHECK_FALSE(exponent_of_amplitude(damping_against_amplitude(cycles, span)).has_value());
}
