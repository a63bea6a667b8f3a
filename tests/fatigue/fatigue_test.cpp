#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

#include "strandyn/fatigue/endurance.hpp"
#include "strandyn/fatigue/rainflow.hpp"
#include "strandyn/fatigue/recorder.hpp"
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

TEST_CASE("recorder: a sine fills one bin, two of them after one another two") {
  Recorder recorder;
  const auto swing = [&](double from, double until, double frequency, double peak_to_peak) {
    for (double t = from; t < until; t += 1 / (frequency * 97)) {
      recorder.add(t, 3e-3 + peak_to_peak / 2 * std::sin(2 * M_PI * frequency * (t - from)));
    }
  };
  swing(0, 10, 20.4, 300e-6);
  swing(10, 20, 33.3, 120e-6);
  const std::vector<RecordedCycles> rows = recorder.matrix();
  double large = 0, small = 0, all = 0;
  for (const RecordedCycles& row : rows) {
    all += row.cycles;
    if (row.frequency == 20.5) large += row.cycles, check_close(row.bending_amplitude, 300e-6, {.relative = 1e-9});
    if (row.frequency == 33.5) small += row.cycles, check_close(row.bending_amplitude, 120e-6, {.relative = 1e-9});
  }
  check_close(large, 203, {.absolute = 1.5});
  check_close(small, 332, {.absolute = 1.5});
  CHECK(all - large - small <= 2);  // where one goes over into the other
}

TEST_CASE("recorder: what it counts of an even vibration rainflow counts, too") {
  Recorder recorder;
  std::vector<double> history;
  for (int i = 0; i <= 40 * 100; ++i) {
    const double t = i / (40.0 * 25);
    history.push_back(200e-6 * std::sin(2 * M_PI * 25 * t));
    recorder.add(t, history.back());
  }
  double counted = 0, flown = 0;
  for (const RecordedCycles& row : recorder.matrix()) counted += row.cycles;
  for (const CountedCycle& cycle : rainflow(history)) {
    if (cycle.range > 390e-6) flown += cycle.count;
  }
  check_close(counted, flown, {.absolute = 1});
}
