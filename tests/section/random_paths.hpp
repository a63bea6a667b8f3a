#pragma once
/// \file Random paths of strain for many section points at once, the same on every machine for the same seed.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "section/battery.hpp"

namespace strandyn::test {

/// STRANDYN_SEED from the environment, or the fixed one.
inline std::uint64_t random_seed() {
  static const std::uint64_t seed = [] {
    const char* text = std::getenv("STRANDYN_SEED");
    const std::uint64_t value = text ? std::stoull(text) : 20160;
    std::printf("random paths: seed %llu (STRANDYN_SEED changes it)\n", static_cast<unsigned long long>(value));
    return value;
  }();
  return seed;
}

/// Uniform numbers straight from the bits: the standard's distributions may differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t stream) : bits_(random_seed() + 1000003 * stream) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_;
};

struct PathPlan {
  std::size_t points = 1;
  std::size_t steps = 1;
  bool axial_moves = true;   ///< axial strain and torsion; otherwise they keep the values of the start
  std::uint64_t stream = 0;  ///< plans with different streams get different paths
};

/// The start (straight, under tension) and then the steps. Each point keeps a step width of its own between 0.3 % and
/// 100 % of the range, so that some points mostly stick and others mostly slip. The strain creeps, and sometimes jumps.
inline std::vector<section::Field> random_paths(section::Dimension dimension, const LawDescription& what,
                                                const PathPlan& plan) {
  using enum section::Component;
  Random random(plan.stream);
  std::vector<double> width;
  for (std::size_t i = 0; i < plan.points; ++i) width.push_back(std::pow(10.0, random.between(-2.5, 0)));

  section::Field now(dimension, plan.points);
  for (std::size_t i = 0; i < plan.points; ++i) now[axial][i] = what.strain * random.between(0.2, 2);
  std::vector<section::Field> path = {now};
  const auto wander = [&](double value, double range, double step) {
    return std::clamp(value + step * range * random.between(-1, 1), -range, range);
  };
  for (std::size_t s = 0; s < plan.steps; ++s) {
    for (std::size_t i = 0; i < plan.points; ++i) {
      now[bending2][i] = wander(now[bending2][i], what.curvature, width[i]);
      if (dimension == section::Dimension::spatial) {
        now[bending3][i] = wander(now[bending3][i], what.curvature, width[i]);
      }
      if (!plan.axial_moves) continue;
      const bool jump = random.between(0, 1) < 0.2;
      const double moved = now[axial][i] + 0.01 * what.strain * random.between(-1, 1);
      now[axial][i] = jump ? what.strain * random.between(-0.3, 2) : moved;
      if (dimension == section::Dimension::spatial) now[torsion][i] = wander(now[torsion][i], what.torsion, width[i]);
    }
    path.push_back(now);
  }
  return path;
}

}  // namespace strandyn::test
