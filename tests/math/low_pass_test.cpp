#include "strandyn/math/low_pass.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/check_close.hpp"

using namespace strandyn::math;
using strandyn::test::check_close;

namespace {

constexpr double cut_off = 40;  // [Hz]

/// Steps of 0.2 to 0.6 ms.
template <class F>
Tabulated sampled(const F& f, double from, double to) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(2e-4, 6e-4);
  Tabulated samples;
  for (double t = from; t < to; t += step(random)) {
    samples.time.push_back(t);
    samples.value.push_back(f(t));
  }
  return samples;
}

/// The largest value between 0.5 and 1.5 s, away from the ends.
template <class F>
double largest(const Tabulated& curve, const F& of) {
  double most = 0;
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    if (curve.time[i] < 0.5 || curve.time[i] > 1.5) continue;
    most = std::max(most, std::abs(of(curve.time[i], curve.value[i])));
  }
  return most;
}

double wave(double frequency, double t) {
  return std::sin(2 * std::numbers::pi * frequency * t + 0.4);
}

}  // namespace

TEST_CASE("low pass: what is slow stays, without delay") {
  for (const double frequency : {2.0, 10.0, 0.7 * cut_off}) {
    CAPTURE(frequency);
    const Tabulated passed = low_pass(sampled([&](double t) { return wave(frequency, t); }, 0, 2), cut_off);
    CHECK(largest(passed, [&](double t, double x) { return x - wave(frequency, t); }) < 1e-3);
  }
}

TEST_CASE("low pass: what is fast is gone, and does not come back as something slow") {
  for (const double frequency : {cut_off, 60.0, 333.0}) {
    CAPTURE(frequency);
    const Tabulated passed = low_pass(sampled([&](double t) { return wave(frequency, t); }, 0, 2), cut_off);
    // Straight lines between uneven samples of a fast wave hold a noise of their own.
    CHECK(largest(passed, [](double, double x) { return x; }) < (frequency < 100 ? 6e-4 : 0.03));
  }
}

TEST_CASE("low pass: a constant stays what it is and a straight line inside of the ends") {
  const Tabulated flat = low_pass({.time = {3, 3.01, 3.5, 4}, .value = {-7, -7, -7, -7}}, cut_off);
  CHECK(flat.time.front() == 3);
  CHECK(flat.time.back() == 4);
  for (const double value : flat.value) check_close(value, -7, {.relative = 1e-13});
  const Tabulated line = low_pass(sampled([](double t) { return 5 * t - 2; }, 0, 2), cut_off);
  CHECK(largest(line, [](double t, double x) { return x - (5 * t - 2); }) < 1e-9);
}
