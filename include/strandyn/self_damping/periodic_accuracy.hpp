#pragma once
/// \file A periodic vibration at resonance that is as fine as an accuracy wants it.
///
/// With P(N, H, S, p) the self-damping on N elements, with H harmonics, S samples and p points a turn,
///     mesh:       |P(N) - P(N/r)|/(r^q - 1)    r the root of two, q by the same difference one mesh further down
///     harmonics:  |P(H) - P(H/2)|              no order is taken for granted; of five and fewer |P(H) - P(H + 2)|
///     samples:    |P(S) - P(S/2)|/3            the half where the harmonics leave it, else 4 H + 4
///     points:     |P(p) - P(p')|               p' the next finer; once finer, those begun with, an order of two taken
/// each with the other knobs as they were begun with, all but the first on a mesh coarser by r, the harmonics on one
/// that has two elements for half a wave of the highest, the last two with three harmonics at most. What gives the
/// largest part is made finer until their sum is below the target; the setting that is left is run once. The first mesh
/// is solved from the mode; every neighbour begins at a solution that is there.

#include <compare>
#include <memory>

#include "strandyn/self_damping/method.hpp"
#include "strandyn/span/shaken_span.hpp"

namespace strandyn::self_damping {

/// What a periodic vibration hangs on.
struct PeriodicSetting {
  int elements = 0, harmonics = 0, samples = 0, points = 0;
  auto operator<=>(const PeriodicSetting&) const = default;
};

/// A span on its shaker, at resonance.
struct PeriodicAsk {
  casefile::Scene scene;  ///< of the span; the knobs that its file sets are kept
  casefile::PeriodicKeys keys;
  double frequency = 0;           ///< [Hz] near which the mode lies
  double antinode_amplitude = 0;  ///< [m] half of peak to peak
  double target = 0;              ///< [-] of the self-damping
};

/// A span on its shaker, and its resonance at the amplitude that was asked for.
struct PeriodicRun {
  std::unique_ptr<span::ShakenSpan> shaken{};
  span::ResonanceAt found{};
  double power = 0;  ///< [W/m] self-damping

  bool converged() const { return found.solution.converged; }
};

struct PeriodicToTarget {
  PeriodicRun run;
  PointError error;
  PeriodicSetting setting;
  section::Effort effort;  ///< of all
};

/// Throws Interrupted where the watch stops it.
PeriodicToTarget periodic_to_target(const PeriodicAsk& ask, const Watch& watch);

/// What it begins with, and what of it the case leaves open.
PeriodicSetting first_periodic_setting(const PeriodicAsk& ask);
PointChoice choice_of(const casefile::Scene& scene, const PeriodicSetting& setting);

/// The span of such a setting on its shaker.
std::unique_ptr<span::ShakenSpan> shaken_span_of(const PeriodicAsk& ask, const PeriodicSetting& setting,
                                                 const Stop& stop);

}  // namespace strandyn::self_damping
