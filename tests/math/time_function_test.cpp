#include "strandyn/math/time_function.hpp"

#include <doctest/doctest.h>

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
