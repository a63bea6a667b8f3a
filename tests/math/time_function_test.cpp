#include "strandyn/math/time_function.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::math;
using strandyn::test::check_close;

TEST_CASE("time function: a constant load is there from the start") {
  CHECK(evaluate(Constant{}, 0) == 1.0);
  CHECK(evaluate(Constant{}, 1e6) == 1.0);
}

TEST_CASE("time function: a harmonic one begins at zero and comes back every period") {
  const Harmonic harmonic{.frequency = 4};
  CHECK(evaluate(harmonic, 0) == 0.0);
  check_close(evaluate(harmonic, 1.0 / 16), 1, {.relative = 1e-15});
  check_close(evaluate(harmonic, 3.0 / 16), -1, {.relative = 1e-15});
  check_close(evaluate(harmonic, 0.01 + 25), evaluate(harmonic, 0.01), {.relative = 1e-12});  // 100 periods later
}

TEST_CASE("time function: a table is straight between its points and constant outside") {
  const Tabulated table{.time = {1, 2, 4}, .value = {10, 20, -20}};
  CHECK(evaluate(table, 0) == 10.0);
  CHECK(evaluate(table, 1) == 10.0);
  CHECK(evaluate(table, 1.5) == 15.0);
  CHECK(evaluate(table, 2) == 20.0);
  CHECK(evaluate(table, 3) == 0.0);
  CHECK(evaluate(table, 4) == -20.0);
  CHECK(evaluate(table, 9) == -20.0);
  CHECK(evaluate(Tabulated{.time = {3}, .value = {7}}, 0) == 7.0);
}

TEST_CASE("time function: a driven one is amplitude times the harmonic of its drive, and rests without one") {
  const Drive drives[] = {{.frequency = 7}, {.frequency = 4, .amplitude = 3, .phase = 0.3}};
  const Harmonic harmonic{.frequency = 4, .phase = 0.3};
  const Driven driven{.drive = 1};
  for (const double t : {0.0, 0.01, 0.37}) {
    CHECK(evaluate(driven, t, drives) == 3 * evaluate(harmonic, t));
    CHECK(rate(driven, t, drives) == 3 * rate(harmonic, t));
  }
  CHECK(evaluate(Driven{.drive = 2}, 0.01, drives) == 0.0);
  CHECK(evaluate(driven, 0.01) == 0.0);
  CHECK(rate(driven, 0.01) == 0.0);
}

TEST_CASE("time function: only a table of few rows has corners") {
  CHECK(corners(Tabulated{.time = {1, 2, 4}, .value = {0, 1, 0}}) == std::vector<double>{1, 2, 4});
  const std::vector<double> signal(51, 0.0);
  CHECK(corners(Tabulated{.time = signal, .value = signal}).empty());
  CHECK(corners(Harmonic{.frequency = 4}).empty());
}

namespace {

/// Largest error of the smooth curve through samples of sin(t) over (0, 6), between the samples.
double error_of_samples(std::size_t samples) {
  Tabulated table;
  for (std::size_t i = 0; i <= samples; ++i) {
    const double t = 6 * static_cast<double>(i) / static_cast<double>(samples);
    table.time.push_back(t);
    table.value.push_back(std::sin(t));
  }
  table = smooth(std::move(table));
  double worst = 0;
  for (int k = 1; k < 600; ++k) worst = std::max(worst, std::abs(table.at(0.01 * k) - std::sin(0.01 * k)));
  return worst;
}

}  // namespace

TEST_CASE("time function: samples are joined by a curve of fourth order with continuous curvature") {
  const double order = std::log2(error_of_samples(20) / error_of_samples(40));
  CHECK(order > 3.7);
  CHECK(error_of_samples(20) < 1e-3);
  // A cubic is its own spline.
  Tabulated cubic;
  for (const double t : {0.0, 1.0, 1.5, 3.0, 4.0}) {
    cubic.time.push_back(t);
    cubic.value.push_back(t * t * t - 2 * t);
  }
  cubic = smooth(std::move(cubic));
  for (const double t : {0.2, 1.2, 2.9, 3.7}) {
    check_close(cubic.at(t), t * t * t - 2 * t, {.relative = 1e-13, .absolute = 1e-13});
    check_close(cubic.rate(t), 3 * t * t - 2, {.relative = 1e-12, .absolute = 1e-12});
  }
}

TEST_CASE("time function: jumps of the rate are those of its corners") {
  const Tabulated ramp{.time = {0, 1, 3}, .value = {0, 2, 2}};
  CHECK(ramp.largest_jump(10) == 2);
  CHECK(ramp.largest_jump(0) == 0);
  const Tabulated zigzag{.time = {0, 1, 2}, .value = {0, 1, 0}};
  CHECK(zigzag.largest_jump(10) == 2);
  CHECK(zigzag.largest_jump(1) == 1);
}

TEST_CASE("time function: an eased one begins and arrives without a jump") {
  const Ease ease{.duration = 2};
  CHECK(ease.at(0) == 0);
  check_close(ease.at(1), 0.5, {.relative = 1e-15});
  CHECK(ease.at(2) == 1);
  CHECK(ease.rate(0) == 0);
  check_close((ease.at(0.7 + 1e-6) - ease.at(0.7 - 1e-6)) / 2e-6, ease.rate(0.7), {.relative = 1e-8});
  CHECK(Ease{}.at(0) == 1);  // at once
  CHECK(Ease{}.rate(0) == 0);
}
