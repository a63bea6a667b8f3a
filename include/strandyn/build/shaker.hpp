#pragma once
/// \file The one harmonic drive of a scene, its shaker: a force at a point, or the motion of a support or a point,
/// across the span along y.

#include "strandyn/build/span.hpp"

namespace strandyn::build {

/// The number of the [[load]] or of the [[motion]] that shakes the span; neither where the scene has no shaker.
struct ShakerKey {
  std::optional<std::size_t> load, motion;
  bool is_given() const { return load || motion; }
};
/// Throws InputError where there are several harmonic drives, or one that is not across the span along y.
ShakerKey shaker_of(const casefile::Scene& scene);

/// The shaker on a chain.
struct Shaker {
  bool moves = false;     ///< its point is led; else a force acts on it
  std::size_t entry = 0;  ///< in model.motions, or in model.loads
  std::size_t node = 0;   ///< where it acts
  double size = 0;        ///< [N] or [m] its amplitude in the scene
  double sign = 1;        ///< its direction along y
  Eigen::Vector3d direction() const { return {0, sign, 0}; }
};
/// Throws InputError where the scene has no shaker, or a force where a support holds the span.
Shaker find_shaker(const casefile::Scene& scene, const BuiltSpan& span);

/// Where a shaker stands that no case has placed: this part of the first loop from the left support. In its middle the
/// force is smallest, and strong damping lets it be tuned.
inline constexpr double shaker_place = 0.5;

}  // namespace strandyn::build
