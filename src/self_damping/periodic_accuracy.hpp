#pragma once
/// \file A point of the method "periodic" that is as fine as an accuracy wants it.
///
/// With P(N, H, S, p) the self-damping on N elements, with H harmonics, S samples and p points a turn, and n = N/2,
///     mesh:       |P(N) - P(n)|/(2^q - 1)      q by the same difference one mesh further down
///     harmonics:  |P(n, H) - P(n, H/2)|        slowly where slip has just begun: no order is taken for granted
///     samples:    |P(n, S) - P(n, S/2)|/3      the half where the harmonics leave it, else 4 H + 4
///     points:     |P(n, p) - P(n, p')|         p' the next finer, or the half where there is none
/// What gives the largest part is made finer until their sum is below the target. The first mesh is solved from the
/// mode; every neighbour begins at a solution that is there already.

#include <compare>
#include <memory>

#include "strandyn/self_damping/method.hpp"
#include "strandyn/span/shaken_span.hpp"

namespace strandyn::self_damping {

/// What a periodic point hangs on.
struct PeriodicSetting {
  int elements = 0, harmonics = 0, samples = 0, points = 0;
  auto operator<=>(const PeriodicSetting&) const = default;
};

/// A span on its shaker, and its resonance at the amplitude of the point.
struct PeriodicRun {
  std::unique_ptr<span::ShakenSpan> shaken{};
  span::ResonanceAt found{};
  double power = 0;  ///< [W/m] self-damping

  bool converged() const { return found.solution.converged; }
};

struct PeriodicToTarget {
  PeriodicRun run;
  PointError error;
  PointChoice chosen;
  section::Effort effort;  ///< of all
};

/// Throws Interrupted where the watch stops it. The knobs that the case sets are kept.
PeriodicToTarget periodic_to_target(const casefile::Scene& scene, const Point& point, double target,
                                    const Watch& watch);

/// What it begins with, and what of it the case leaves open.
PeriodicSetting first_periodic_setting(const casefile::Scene& scene, const Point& point, double target);
PointChoice choice_of(const casefile::Scene& scene, const PeriodicSetting& setting);

}  // namespace strandyn::self_damping
