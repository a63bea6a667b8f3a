#include "strandyn/observe/cycles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "observe/driven.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::observe::Account;
using strandyn::observe::Cycle;
using strandyn::observe::CycleObserver;
using strandyn::observe::Profile;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::Driven;
using strandyn::test::ShapeAt;
using strandyn::test::SpanOptions;
using strandyn::test::Swing;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double period = 0.2;  // [s]
/// Sixteen elements a wave, read at eight places each: pi^2/2 (1/128)^2 below the crest at worst.
constexpr double near_crest = 3.1e-4;

Swing swing(double t, double amplitude) {
  const double omega = 2 * pi / period;
  return {.deflection = amplitude * std::sin(omega * t), .rate = amplitude * omega * std::cos(omega * t)};
}

/// 6 m in three loops of 2 m; deflections of 3 cm bend it beyond chi_0.
Driven frictional_span(double amplitude) {
  model::Model model = curlew_span(test::return_map(), {.length = 6, .elements = 24, .graded = false, .drag = 0.4});
  model.loads = {{.node = 4, .force = {0, 20, 0}, .history = model::Harmonic{.frequency = 1 / period}}};
  return {std::move(model), test::sine_shape(2), [amplitude](double t) { return swing(t, amplitude); }};
}

void run(Driven& span, CycleObserver& observer, double step, int steps) {
  span.begin(observer);
  for (int i = 1; i <= steps; ++i) span.step_to(observer, i * step);
}

/// [J] of a profile over the whole span.
double total_friction(const Profile& profile, const system::System& system) {
  double sum = 0;
  for (std::size_t i = 0; i < profile.friction.size(); ++i) sum += profile.friction[i] * system.point_length(i);
  return sum;
}

}  // namespace

TEST_CASE("cycles: their works and losses add up to the ledger, steps meeting the ends or not") {
  // 40 steps a cycle, and 64 steps in seven cycles.
  for (const auto& [step, steps] : {std::pair{period / 40, 280}, {7 * period / 64, 64}}) {
    Driven span = frictional_span(0.03);
    CycleObserver observer({.period = period, .loop_length = 2});
    run(span, observer, step, steps);
    REQUIRE(observer.cycles().size() == 7);
    Account sum;
    double viscous = 0;
    for (const Cycle& c : observer.cycles()) {
      sum.external_work += c.external_work;
      sum.friction += c.friction;
      viscous += c.viscous;
      sum.quadrature_error += c.quadrature_error;
      sum.internal_work += c.internal_work;
    }
    const Account& end = observer.ledger().now();
    CHECK(end.friction > 1);
    check_close(sum.external_work, end.external_work, {.relative = 1e-12});
    check_close(sum.friction, end.friction, {.relative = 1e-12});
    check_close(viscous, end.viscous.total(), {.relative = 1e-12});
    check_close(sum.quadrature_error, end.quadrature_error, {.relative = 1e-12});
    check_close(sum.internal_work, end.internal_work, {.relative = 1e-12});
    check_close(observer.cycles().back().kinetic, end.kinetic, {.relative = 1e-12});
    check_close(observer.cycles().back().end_time, 7 * period, {.relative = 1e-14});
  }
}

TEST_CASE("cycles: what comes in is stored or lost in every single cycle, also where its end lies inside a step") {
  Driven span = frictional_span(0.03);
  CycleObserver observer({.period = period, .loop_length = 2});
  run(span, observer, 0.37 * period / 10, 200);
  REQUIRE(observer.cycles().size() == 7);
  double kinetic = observer.ledger().now().initial_kinetic;
  double elastic = 0;
  for (const Cycle& c : observer.cycles()) {
    const double remainder =
        c.external_work - (c.kinetic - kinetic) - (c.elastic - elastic) - c.friction - c.viscous - c.numerical;
    check_close(remainder, 0, {.absolute = 1e-12 * (c.kinetic + c.friction)});
    kinetic = c.kinetic;
    elastic = c.elastic;
  }
}

TEST_CASE("cycles: a step over several ends closes several cycles") {
  Driven span = frictional_span(0.001);
  CycleObserver observer({.period = period, .loop_length = 2});
  run(span, observer, 2.5 * period, 2);
  REQUIRE(observer.cycles().size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    check_close(observer.cycles()[i].end_time, static_cast<double>(i + 1) * period, {.relative = 1e-14});
  }
}

TEST_CASE("cycles: the antinode amplitude is half of peak to peak, whatever the mean") {
  model::Model model = curlew_span(test::stick_law(), {.length = 12, .elements = 48, .graded = false});
  Driven span(std::move(model), test::sine_shape(2), [](double t) {
    Swing s = swing(t, 4e-3);
    s.deflection += 1e-3;
    return s;
  });
  CycleObserver observer({.period = period, .loop_length = 2});
  run(span, observer, period / 40, 80);
  for (const Cycle& c : observer.cycles()) check_close(c.antinode_amplitude, 4e-3, {.relative = near_crest});
}

TEST_CASE("cycles: loops at the ends do not count as antinodes where there are others") {
  const auto largest = [](double length) {
    model::Model model = curlew_span(
        test::stick_law(), {.length = length, .elements = static_cast<std::size_t>(8 * length), .graded = false});
    // Loops of 2 m; those at the ends swing five times as wide.
    Driven span(
        std::move(model),
        [length](double x) {
          const double size = x < 1.99 || x > length - 1.99 ? 5 : 1;
          return ShapeAt{.value = size * std::sin(pi * x / 2), .slope = size * pi / 2 * std::cos(pi * x / 2)};
        },
        [](double t) { return swing(t, 1e-3); });
    CycleObserver observer({.period = period, .loop_length = 2});
    run(span, observer, period / 40, 40);
    return observer.cycles().front().antinode_amplitude;
  };
  check_close(largest(12), 1e-3, {.relative = near_crest});
  check_close(largest(6), 1e-3, {.relative = near_crest});
  check_close(largest(4), 5e-3, {.relative = near_crest});  // two loops: there is nothing between them
}

TEST_CASE("cycles: the friction along the span integrates to that of the cycles") {
  Driven span = frictional_span(0.03);
  CycleObserver observer({.period = period, .loop_length = 2, .kept = 3});
  run(span, observer, period / 40, 5 * 40);
  const Profile profile = observer.profile(span.system);
  CHECK(profile.cycles == 3);
  double mean = 0;
  for (std::size_t i = 2; i < 5; ++i) mean += observer.cycles()[i].friction / 3;
  check_close(total_friction(profile, span.system), mean, {.relative = 1e-12});
}

TEST_CASE("cycles: the profile lies at the section points and shows where wires slip") {
  Driven span = frictional_span(0.03);
  CycleObserver observer({.period = period, .loop_length = 2});
  run(span, observer, period / 40, 2 * 40);
  const Profile profile = observer.profile(span.system);
  REQUIRE(profile.position.size() == 48);
  check_close(profile.position[0], 0.25 * beam::gauss_position[0], {.relative = 1e-12});
  check_close(profile.position[47], 5.75 + 0.25 * beam::gauss_position[1], {.relative = 1e-12});
  std::size_t slipping = 0;
  for (std::size_t e = 0; e < 24; ++e) slipping += profile.friction[2 * e] > 0 || profile.friction[2 * e + 1] > 0;
  CHECK(observer.cycles().back().elements_slipping == slipping);
  CHECK(slipping > 0);
  CHECK(profile.cycles == 2);
}

TEST_CASE("cycles: curvature amplitudes are those of the committed sections") {
  // Rotations stay zero while the nodes go up and down: the curvature of an element is that of its chord's turn alone.
  model::Model model = curlew_span(test::stick_law(), {.length = 6, .elements = 6, .graded = false});
  Driven span(
      std::move(model), [](double x) { return ShapeAt{.value = x < 2.5 ? 0.0 : 1.0}; },
      [](double t) { return swing(t, 2e-3); });
  CycleObserver observer({.period = period, .loop_length = 2});
  run(span, observer, period / 40, 40);
  const Profile profile = observer.profile(span.system);
  const double unstressed = span.model.elements[2].length;
  for (std::size_t g = 0; g < 2; ++g) {
    const double turn = 2e-3;  // over one metre; to the third power less
    const double expected = std::abs(12 * beam::gauss_position[g] - 6) * turn / unstressed;
    check_close(profile.curvature_amplitude[4 + g], expected, {.relative = 1e-5});
    check_close(profile.curvature_amplitude[g], 0, {.absolute = 1e-15});
  }
}
