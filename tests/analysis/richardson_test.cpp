#include "strandyn/analysis/richardson.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn;
using analysis::richardson;
using test::check_close;

namespace {

constexpr analysis::Order second = {.least = 1, .highest = 4, .expected = 2};

}  // namespace

TEST_CASE("richardson: of errors of the order that is expected it gives half as much again, of others more") {
  for (const double q : {2.0, 3.0, 4.0}) {
    const auto run = [q](double h) { return 7 + 0.01 * std::pow(h, q); };
    check_close(richardson(run(2) - run(1), run(4) - run(2), second), 1.5 * 0.01, {.relative = 1e-10});
  }
  const auto slow = [](double h) { return 7 + 0.01 * h; };
  check_close(richardson(slow(2) - slow(1), slow(4) - slow(2), second), 3 * 0.01, {.relative = 1e-10});
  check_close(richardson(3e-3, std::nullopt, second), 2.5e-3, {.relative = 1e-14});
}

TEST_CASE("richardson: runs finer by another ratio than two say the same of the finest") {
  constexpr analysis::Order by_root = {.least = 1, .highest = 4, .expected = 2, .ratio = 1.41421356237309505};
  for (const double q : {2.0, 3.0, 4.0}) {
    const auto run = [q](double h) { return 7 + 0.01 * std::pow(h, q); };
    const double r = by_root.ratio;
    check_close(richardson(run(r) - run(1), run(r * r) - run(r), by_root), 1.5 * 0.01, {.relative = 1e-10});
  }
}

TEST_CASE("richardson: steps from run to run need not be alike") {
  constexpr analysis::Order uneven = {.least = 1, .highest = 4, .expected = 2, .ratio = 1.5, .ratio_before = 3};
  for (const double q : {2.0, 3.0, 4.0}) {
    const auto run = [q](double h) { return 7 + 0.01 * std::pow(h, q); };
    check_close(richardson(run(1.5) - run(1), run(4.5) - run(1.5), uneven), 1.5 * 0.01, {.relative = 1e-9});
  }
}

TEST_CASE("richardson: two runs that agree by chance are not believed") {
  CHECK(richardson(0, 1e-3, second) >= 1.5 * 1e-3 / 16 / 15);
  CHECK(richardson(1e-9, 1e-3, second) >= 1.5 * 1e-3 / 16 / 15 * (1 - 1e-12));
}

TEST_CASE("richardson: where nothing differs there is no error, and where a run has failed no bound") {
  CHECK(richardson(0, 0, second) == 0);
  CHECK(richardson(0, std::nullopt, second) == 0);
  CHECK(std::isinf(richardson(INFINITY, 1e-3, second)));
  CHECK(std::isinf(richardson(INFINITY, INFINITY, second)));
  check_close(richardson(3e-3, INFINITY, second), 2.5e-3, {.relative = 1e-14});
}
