#include "strandyn/observe/ledger.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "observe/driven.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::observe::Account;
using strandyn::observe::Ledger;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::Driven;
using strandyn::test::ShapeAt;
using strandyn::test::Swing;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double frequency = 5;     // [Hz]
constexpr double amplitude = 3e-3;  // [m]
constexpr double lag = 0.7;         // [rad] of the motion behind the force

Swing harmonic_swing(double t) {
  const double omega = 2 * pi * frequency;
  return {.deflection = amplitude * std::sin(omega * t - lag), .rate = amplitude * omega * std::cos(omega * t - lag)};
}

Driven harmonic_span(double drag) {
  model::Model model = curlew_span(test::stick_law(), {.length = 6, .elements = 10, .graded = false, .drag = drag});
  model.loads = {{.node = 5, .force = {0, 20, 0}, .history = model::Harmonic{.frequency = frequency}}};
  return {std::move(model), [](double) { return ShapeAt{.value = 1}; }, harmonic_swing};
}

/// After one period in equal steps.
Account after_one_period(Driven& span, int steps) {
  Ledger ledger;
  span.begin(ledger);
  for (int i = 1; i <= steps; ++i) span.step_to(ledger, i / (frequency * steps));
  return ledger.now();
}

}  // namespace

TEST_CASE("ledger: a harmonic force does pi F A sin(lag) in a period on a harmonic motion") {
  for (const int steps : {8, 100}) {
    Driven span = harmonic_span(0);
    // The trapezoidal sum over N equal steps is N/2 sin(2 pi/N) of that, in place of pi: exact.
    const double expected = 20 * amplitude * std::sin(lag) * steps / 2 * std::sin(2 * pi / steps);
    const Account account = after_one_period(span, steps);
    check_close(account.external_work, expected, {.relative = 1e-12});
    CHECK(account.viscous.total() == 0.0);
    CHECK(account.friction == 0.0);
  }
}

TEST_CASE("ledger: drag takes c V^2/2 per length and time from a harmonic motion") {
  const double drag = 0.4;
  Driven span = harmonic_span(drag);
  const Account account = after_one_period(span, 50);
  const double V = 2 * pi * frequency * amplitude;
  // The nodes at the supports stand still with half an element each.
  const double moving = span.model.unstressed_length() * 9 / 10;
  check_close(account.viscous.total(), 0.5 * drag * V * V * moving / frequency, {.relative = 1e-12});
}

TEST_CASE("ledger: the state's energies return after a period and the remainder is what the terms leave over") {
  Driven span = harmonic_span(0.4);
  Ledger ledger;
  span.begin(ledger);
  const double kinetic = ledger.now().kinetic;
  CHECK(kinetic > 0);
  check_close(ledger.now().initial_kinetic, kinetic, {});
  CHECK(ledger.now().numerical() == 0.0);
  for (int i = 1; i <= 16; ++i) {
    span.step_to(ledger, i / (frequency * 16));
    const Account& a = ledger.now();
    check_close(a.external_work - (a.kinetic - kinetic) - a.elastic - a.friction - a.viscous.total() - a.numerical(), 0,
                {.absolute = 1e-14 * kinetic});
  }
  check_close(ledger.now().kinetic, kinetic, {.relative = 1e-12});
  check_close(ledger.now().elastic, 0, {.absolute = 1e-10 * kinetic});
}

TEST_CASE("ledger: elastic energy counts from the start although the span is under tension") {
  Driven span = harmonic_span(0);
  Ledger ledger;
  span.begin(ledger);
  CHECK(ledger.now().elastic == 0.0);
  span.step_to(ledger, (0.25 + lag / (2 * pi)) / frequency);  // the largest deflection
  const double at_peak = ledger.now().elastic;
  // T/2 int w'^2 of two end elements that go up by (1 - sin^2 lag), plus bending there.
  const double slope2 = amplitude * amplitude * std::pow(std::cos(lag), 2) / (0.6 * 0.6);
  CHECK(at_peak > 0.5 * test::curlew_tension * slope2 * 1.2);
}

TEST_CASE("ledger: internal work is a second way to stored and dissipated energy, with an error of the step squared") {
  const auto mismatch = [](int steps) {
    model::Model model = curlew_span(test::return_map(), {.length = 6, .elements = 10, .graded = false});
    Driven span(std::move(model), test::sine_shape(2),
                [](double t) { return Swing{.deflection = 0.03 * std::sin(2 * pi * frequency * t)}; });
    const Account a = after_one_period(span, steps);
    CHECK(a.friction > 1);
    return std::abs(a.internal_work - (a.elastic + a.friction - a.quadrature_error)) / a.friction;
  };
  const double coarse = mismatch(50);
  const double fine = mismatch(100);
  CHECK(coarse < 5e-3);
  CHECK(coarse / fine > 3);
}

TEST_CASE("ledger: between two accounts every term is on a straight line and so is the remainder") {
  const Account from{.external_work = 1,
                     .kinetic = 2,
                     .elastic = 3,
                     .friction = 4,
                     .viscous = {.drag = 5},
                     .quadrature_error = 0.1,
                     .internal_work = 6,
                     .initial_kinetic = 7};
  const Account to{.external_work = 11,
                   .kinetic = 22,
                   .elastic = 1,
                   .friction = 8,
                   .viscous = {.drag = 9},
                   .quadrature_error = 0.5,
                   .internal_work = -6,
                   .initial_kinetic = 7};
  const Account between = interpolate(from, to, 0.25);
  check_close(between.external_work, 3.5, {.relative = 1e-15});
  check_close(between.kinetic, 7, {.relative = 1e-15});
  check_close(between.elastic, 2.5, {.relative = 1e-15});
  check_close(between.friction, 5, {.relative = 1e-15});
  check_close(between.viscous.drag, 6, {.relative = 1e-15});
  check_close(between.quadrature_error, 0.2, {.relative = 1e-15});
  check_close(between.internal_work, 3, {.relative = 1e-15});
  check_close(between.initial_kinetic, 7, {});
  check_close(between.numerical(), 0.75 * from.numerical() + 0.25 * to.numerical(), {.relative = 1e-14});
}
