#include "strandyn/air/wake_oscillator.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/check_close.hpp"

using std::numbers::pi;
using strandyn::air::Wake;
using strandyn::air::WakeModel;
using strandyn::test::check_close;

namespace {

constexpr double speed = 3;  // [m/s]
constexpr WakeModel model{.diameter = 0.028};

Wake after(Wake wake, double step, int steps) {
  for (int i = 0; i < steps; ++i) wake = advance(model, speed, wake, {.length = step});
  return wake;
}

}  // namespace

TEST_CASE("wake oscillator: behind a cylinder at rest its fundamental is 2.001 and omega_f (1 - epsilon^2/16)") {
  const double shedding = model.strouhal * speed / model.diameter;
  const double expected = shedding * (1 - model.epsilon * model.epsilon / 16);
  const double step = 1 / (expected * 400);
  Wake wake = after({.q = 0.1}, step, 60 * 400);
  // Periods from upward passes through zero, the fundamental from whole periods of that length.
  double first = 0, last = 0, before = wake.q;
  int passes = 0;
  for (int i = 1; passes < 41; ++i) {
    wake = advance(model, speed, wake, {.length = step});
    if (before < 0 && wake.q >= 0) {
      last = (i - wake.q / (wake.q - before)) * step;
      if (passes++ == 0) first = last;
    }
    before = wake.q;
  }
  const double period = (last - first) / 40;
  check_close(1 / period, expected, {.relative = 1e-3});
  std::complex<double> sum;
  constexpr int samples = 2000;
  for (int i = 0; i < samples; ++i) {
    wake = advance(model, speed, wake, {.length = period / samples});
    sum += wake.q * std::polar(2.0 / samples, -2 * pi * (i + 1) / samples);
  }
  check_close(std::abs(sum), 2.001, {.relative = 2e-3});
}

TEST_CASE("wake oscillator: one long step is many short ones, to the fourth order of its substeps") {
  const Wake start{.q = 1.2, .rate = -40};
  const double length = 0.05;  // one period
  const Wake one = advance(model, speed, start, {.length = length, .from = 3, .to = -5});
  Wake many = start;
  constexpr int parts = 64;
  for (int i = 0; i < parts; ++i) {
    const auto at = [&](int k) { return 3 - 8.0 * k / parts; };
    many = advance(model, speed, many, {.length = length / parts, .from = at(i), .to = at(i + 1)});
  }
  check_close(one.q, many.q, {.absolute = 2e-4});
  check_close(one.rate, many.rate, {.absolute = 2e-4 * model.angular_frequency(speed)});
}

TEST_CASE("wake oscillator: without van der Pol damping a swing forces it as a linear oscillator") {
  // q = (A/D) a/(omega_f^2 - w^2) of a swing with the acceleration amplitude a at w.
  WakeModel calm = model;
  calm.epsilon = 1e-9;
  const double omega = calm.angular_frequency(speed);
  const double w = 0.05 * omega, acceleration = 0.2;
  Wake wake{.q = calm.coupling / calm.diameter * acceleration / (omega * omega - w * w)};
  const double step = 2 * pi / w / 4000;
  double largest = 0;
  for (int i = 0; i < 8000; ++i) {
    wake = advance(calm, speed, wake,
                   {.length = step,
                    .from = acceleration * std::cos(w * i * step),
                    .to = acceleration * std::cos(w * (i + 1) * step)});
    largest = std::max(largest, std::abs(wake.q));
  }
  check_close(largest, calm.coupling / calm.diameter * acceleration / (omega * omega - w * w), {.relative = 1e-3});
}
