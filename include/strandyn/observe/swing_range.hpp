#pragma once
/// \file How far places of a span swing, whatever the direction: half of the greatest distance between two positions of
/// a place, across the reference line.
///
/// In a plane, half of highest less lowest. In space a place draws a curve in the plane across; of its points those
/// that lie farthest in 16 directions are kept, and the greatest distance between any two of these is taken. It is
/// exact for a line at any angle and for a circle, and misses that of an ellipse by less than 0.5 %.

#include <array>
#include <cstddef>
#include <vector>

#include "strandyn/core/archive.hpp"
#include "strandyn/observe/deflection_points.hpp"

namespace strandyn::observe {

class SwingRange {
 public:
  /// Forgets what was seen.
  void restart(const DeflectionPoints& places);
  /// A state of the span; `u` holds all unknowns.
  void widen(const DeflectionPoints& places, const double* u);
  /// [m] at the place that swings farthest; 0 where nothing was seen.
  double largest() const;

  void archive(Archive& a) {
    a.same(planes_, "number of planes");
    a(low_, high_, farthest_);
  }

 private:
  static constexpr std::size_t directions = 8;  ///< of half a turn, each to both sides
  /// The point that lies farthest along one way of a direction. [m]
  struct Farthest {
    double along = 0, y = 0, z = 0;
    void archive(Archive& a) { a(along, y, z); }
  };

  std::size_t planes_ = 1;
  std::vector<double> low_, high_;  // [m] of each place of a planar chain
  std::vector<Farthest> farthest_;  // 2 * directions of each place of a spatial chain
};

}  // namespace strandyn::observe
