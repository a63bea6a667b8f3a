#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

#include "strandyn/fatigue/endurance.hpp"
#include "strandyn/fatigue/rainflow.hpp"
#include "support/check_close.hpp"

using namespace strandyn::fatigue;
using strandyn::test::check_close;

namespace {

std::map<double, double> by_range(const std::vector<double>& history) {
  std::map<double, double> counts;
  for (const CountedCycle& cycle : rainflow(history)) counts[cycle.range] += cycle.count;
  return counts;
}

}  // namespace

TEST_CASE("rainflow: the standard's own example") {
  // ASTM E1049-85, figure 6.
  const std::map<double, double> expected = {{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1}, {9, 0.5}};
  CHECK(by_range({-2, 1, -3, 5, -1, 3, -4, 4, -2}) == expected);
}

TEST_CASE("rainflow: points on the way and points that stand still do not count") {
  CHECK(by_range({-2, -1, 1, 1, 0, -3, -3, 2, 5, -1, 3, 1, -4, 4, -2}) == by_range({-2, 1, -3, 5, -1, 3, -4, 4, -2}));
  CHECK(rainflow(std::vector<double>{2, 2, 2}).empty());
  CHECK(rainflow(std::vector<double>{}).empty());
}

TEST_CASE("rainflow: a sine is as many cycles as it has, a small ripple on a large swing counts by itself") {
  std::vector<double> sine, both;
  for (int i = 0; i <= 4000; ++i) {
    const double t = 2 * M_PI * i / 400;
    sine.push_back(3 * std::sin(t));
    both.push_back(std::sin(t) + 0.2 * std::sin(20 * t));
  }
  double swings = 0;
  for (const CountedCycle& c : rainflow(sine)) {
    if (c.range > 5.99) swings += c.count;
  }
  check_close(swings, 9.5, {.absolute = 1e-9});  // the quarters at the ends are smaller halves
  double large = 0, small = 0;
  for (const CountedCycle& c : rainflow(both)) (c.range > 1.5 ? large : small) += c.count;
  check_close(large, 10, {.relative = 0.06});
  CHECK(small > 100);  // where the swing does not outrun the ripple
}

TEST_CASE("endurance: the border line is passed both ways, and does not rise at its knee") {
  for (const AluminiumLayers layers : {AluminiumLayers::one, AluminiumLayers::several}) {
    for (const double n : {1e5, 1e6, 1.9e7, 1e8, 1e9}) {
      check_close(cycles_endured(layers, stress_endured(layers, n)), n, {.relative = 1e-10});
    }
    CHECK(stress_endured(layers, 2.01e7) < stress_endured(layers, 2e7));
    CHECK(std::isinf(cycles_endured(layers, 0)));
  }
  check_close(stress_endured(AluminiumLayers::several, 2e7), 15.6e6, {.relative = 2e-3});
  check_close(cycles_endured(AluminiumLayers::several, 15.3e6), 2e7, {.relative = 1e-12});
  check_close(stress_endured(AluminiumLayers::several, 5e8), 8.73e6, {.relative = 2e-3});
}

TEST_CASE("endurance: Miner's sum of halves of lives is one") {
  const double n = cycles_endured(AluminiumLayers::several, 20e6), m = cycles_endured(AluminiumLayers::several, 10e6);
  const std::vector<StressCycles> spectrum = {{20e6, n / 2}, {10e6, m / 2}, {0, 1e12}};
  check_close(damage(AluminiumLayers::several, spectrum), 1.0, {.relative = 1e-12});
  CHECK(endurance_limits().size() == 3);
  for (const EnduranceLimit& limit : endurance_limits()) CHECK(limit.stress < 30e6);
}
