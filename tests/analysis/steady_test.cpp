#include "strandyn/analysis/steady.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr SpanNumbers span{.frequency = 25, .length = 40, .mass_per_length = 2};

std::vector<CycleLosses> cycles_of(std::size_t number, const CycleLosses& each) {
  return std::vector<CycleLosses>(number, each);
}

}  // namespace

TEST_CASE("steady state: self-damping, damping ratio and loss factor of a span computed by hand") {
  const CycleLosses cycle{.antinode_amplitude = 2e-3, .friction = 0.03, .viscous = 0.01, .numerical = 0.002};
  const SteadyState s = steady_state(cycles_of(30, cycle), span);
  CHECK(s.cycles == 20);
  check_close(s.antinode_amplitude, 2e-3, {.relative = 1e-14});
  check_close(s.dissipation, 0.04, {.relative = 1e-14});
  // 0.04 J in 1/25 s over 40 m.
  check_close(s.self_damping, 0.025, {.relative = 1e-14});
  // omega = 50 pi, V = 0.1 pi m/s: zeta = 2 . 0.025/(2 . 50 pi . 0.01 pi^2) = 0.05/pi^3.
  check_close(s.damping_ratio, 0.05 / (pi * pi * pi), {.relative = 1e-14});
  check_close(s.loss_factor, 0.1 / (pi * pi * pi), {.relative = 1e-14});
  check_close(s.numerical_share.value(), 0.05, {.relative = 1e-14});
}

TEST_CASE("steady state: the damping ratio is that of a decaying mode") {
  // A mode of energy E = m L V^2/4 that loses 4 pi zeta E per cycle.
  const double zeta = 1.3e-3;
  const double V = 2 * pi * span.frequency * 5e-3;
  const double energy = span.mass_per_length * span.length * V * V / 4;
  const CycleLosses cycle{.antinode_amplitude = 5e-3, .friction = 4 * pi * zeta * energy};
  check_close(steady_state(cycles_of(20, cycle), span).damping_ratio, zeta, {.relative = 1e-13});
}

TEST_CASE("steady state: only the last cycles count and fewer than asked are all taken") {
  std::vector<CycleLosses> cycles = cycles_of(50, {.antinode_amplitude = 1, .friction = 100, .numerical = 100});
  for (const double friction : {0.1, 0.2, 0.6}) {
    cycles.push_back({.antinode_amplitude = 1e-3, .friction = friction, .numerical = -0.03});
  }
  const SteadyState s = steady_state(cycles, span, 3);
  CHECK(s.cycles == 3);
  check_close(s.dissipation, 0.3, {.relative = 1e-14});
  check_close(s.antinode_amplitude, 1e-3, {.relative = 1e-14});
  check_close(s.numerical_share.value(), 0.1, {.relative = 1e-14});  // its size counts, not its sign
  CHECK(steady_state(cycles, span, 1000).cycles == 53);
}

TEST_CASE("steady state: the numerical part is never folded into the losses") {
  const CycleLosses clean{.antinode_amplitude = 1e-3, .friction = 0.1};
  CycleLosses noisy = clean;
  noisy.numerical = 0.09;
  const SteadyState a = steady_state(cycles_of(20, clean), span);
  const SteadyState b = steady_state(cycles_of(20, noisy), span);
  CHECK(a.self_damping == b.self_damping);
  CHECK(a.damping_ratio == b.damping_ratio);
  CHECK(a.numerical_share.value() == 0.0);
  check_close(b.numerical_share.value(), 0.9, {.relative = 1e-14});
}

TEST_CASE("steady state: parts of either sign cancel in the numerical share as they do in the ledger") {
  std::vector<CycleLosses> cycles = cycles_of(2, {.antinode_amplitude = 1e-3, .friction = 1});
  cycles[0].numerical = 0.5;
  cycles[1].numerical = -0.4;
  check_close(steady_state(cycles, span).numerical_share.value(), 0.05, {.relative = 1e-13});
}

TEST_CASE("steady state: where nothing is dissipated there is no numerical share") {
  const SteadyState s =
      steady_state(cycles_of(20, {.antinode_amplitude = 1e-3, .friction = 0, .viscous = 0, .numerical = 0.01}), span);
  CHECK_FALSE(s.numerical_share.has_value());
  CHECK(s.damping_ratio == 0.0);
  CHECK(s.self_damping == 0.0);
}

TEST_CASE("steady state: a span at rest and a run without cycles give no ratio of zero by zero") {
  const SteadyState rest = steady_state(cycles_of(20, {}), span);
  CHECK(rest.damping_ratio == 0.0);
  CHECK(rest.loss_factor == 0.0);
  const SteadyState none = steady_state({}, span);
  CHECK(none.cycles == 0);
  CHECK(none.self_damping == 0.0);
  CHECK_FALSE(none.numerical_share.has_value());
}

TEST_CASE("steadiness: modes that beat do not make a vibration unsteady, growth and decay do") {
  const auto flows = [](double growth, double beat, double in_over_lost) {
    std::vector<CycleFlow> cycles;
    for (int i = 0; i < 20; ++i) {
      const double amplitude = std::exp(growth * i) * (1 + beat * std::cos(2 * pi * 0.3 * i));
      const double lost = 0.1 * std::pow(std::exp(growth * i), 3);
      cycles.push_back({.amplitude = amplitude, .in = in_over_lost * lost, .lost = lost});
    }
    return cycles;
  };
  CHECK(is_steady(steadiness(flows(0, 0, 1))));
  CHECK(is_steady(steadiness(flows(0, 0.005, 1))));
  CHECK_FALSE(is_steady(steadiness(flows(0, 0, 1.006))));  // more comes in than is lost
  CHECK_FALSE(is_steady(steadiness(flows(0, 0, 0.994))));
  CHECK_FALSE(is_steady(steadiness(flows(1e-4, 0, 1))));  // 0.2 % of the amplitude, 0.6 % of the loss
  CHECK_FALSE(is_steady(steadiness(flows(-1e-4, 0, 1))));
  CHECK(is_steady(steadiness(flows(5e-5, 0, 1))));
  check_close(steadiness(flows(1e-4, 0, 1)).amplitude_drift, 19e-4, {.relative = 1e-3});
  check_close(steadiness(flows(1e-4, 0, 1)).loss_drift, 57e-4, {.relative = 1e-3});
  check_close(steadiness(flows(0, 0.005, 1.3)).work_in_over_lost.value(), 1.3, {.relative = 1e-12});
}

TEST_CASE("steadiness: fewer than twenty cycles show nothing, nor does a span that loses nothing") {
  const std::vector<CycleFlow> cycles(19, {.amplitude = 1, .in = 0.1, .lost = 0.1});
  CHECK_FALSE(is_steady(steadiness(cycles)));
  const std::vector<CycleFlow> still(20, CycleFlow{.amplitude = 1});
  CHECK_FALSE(is_steady(steadiness(still)));
  CHECK_FALSE(steadiness(still).work_in_over_lost.has_value());
}
