#include "strandyn/self_damping/fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

using namespace strandyn;
using self_damping::FitRow;

namespace {

/// At frequencies a per cent apart and one amplitude and tension: what a study that was stopped early has.
std::vector<analysis::SelfDampingPoint> points_from_20_Hz(std::initializer_list<double> powers) {
  std::vector<analysis::SelfDampingPoint> points;
  double frequency = 20;
  for (const double power : powers) {
    points.push_back({.at = {.antinode_amplitude = 4e-3, .frequency = frequency, .tension = 28e3}, .power = power});
    frequency *= 1.015;
  }
  return points;
}

}  // namespace

TEST_CASE("fit row: a factor or an end of its interval beyond what a number can hold is left out") {
  // From below to above the onset of slip: f^1600 and more.
  const FitRow steep = self_damping::fit_row(points_from_20_Hz({1e-12, 0.5}));
  CHECK(steep.m.has_value());
  CHECK_FALSE(steep.k.has_value());
  CHECK_FALSE(steep.k_interval.has_value());

  // A power of about 7, but three points with scatter: ln k is known to some thousands only.
  const FitRow scattered = self_damping::fit_row(points_from_20_Hz({0.4, 0.9, 0.5}));
  CHECK(scattered.k.has_value());
  CHECK(scattered.m_interval.has_value());
  CHECK_FALSE(scattered.k_interval.has_value());

  const FitRow usual = self_damping::fit_row(points_from_20_Hz({0.4, 0.43, 0.462}));
  REQUIRE(usual.k_interval.has_value());
  CHECK(*usual.k > (*usual.k_interval)[0]);
  CHECK(*usual.k < (*usual.k_interval)[1]);
}
