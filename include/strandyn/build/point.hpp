#pragma once
/// \file The span on which one point of a self-damping study is vibrated.
///
/// A point has a span of its own: the scene's at the point's tension. Where the point names a frequency, the span is as
/// long as its mode nearest to that frequency wants it, all wires sticking, as in the quadrature over clamped modes;
/// where it names a mode, the length stays. Shaker: the scene's harmonic force or motion, else a force in the first
/// loop
/// (`shaker_place`). Points share nothing, so their order does not matter, and all methods shake at the same place.

#include "strandyn/build/shaker.hpp"

namespace strandyn::build {

/// What a point asks of its span.
struct PointAsk {
  double frequency = 0;       ///< [Hz]
  double tension = 0;         ///< [N]
  std::optional<int> mode{};  ///< where the case named the frequency by a mode of the span, from 1
};

/// The number of its mode and the length of the span at which that mode has the frequency of the point [Hz].
struct SpanOfPoint {
  int mode = 1;
  double length = 0;  ///< [m]
};
SpanOfPoint span_of_point(const casefile::Scene& scene, const PointAsk& point);

/// The scene with that span, the tension of the point and its shaker. What is nearer to the right support than to the
/// left one keeps its distance from the right one.
casefile::Scene scene_of_point(const casefile::Scene& scene, const PointAsk& point);

}  // namespace strandyn::build
