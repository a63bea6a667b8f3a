#pragma once
/// \file The road "periodic": the steady state of a shaken span, solved directly at phase resonance.
///
/// A point has a span of its own: the scene's at the point's tension. Where the point names a frequency, the span is as
/// long as its mode nearest to that frequency wants it, all wires sticking, as on the road "quadrature" over clamped
/// modes; where it names a mode, the length stays. Shaker: the scene's harmonic force or motion, else a force at a
/// quarter of a loop from the left support. Points share nothing, so their order does not matter.

#include "strandyn/study/self_damping.hpp"

namespace strandyn::study {

/// The number of its mode and the length of the span at which that mode has the frequency of the point [Hz].
struct SpanOfPoint {
  int mode = 1;
  double length = 0;  ///< [m]
};
SpanOfPoint span_of_point(const casefile::Scene& scene, const Point& point);

/// The scene with that span, the tension of the point and its shaker. What is nearer to the right support than to the
/// left one keeps its distance from the right one. `shaker_place` is for a scene without a shaker: of a loop, from the
/// left support.
casefile::Scene scene_of_point(const casefile::Scene& scene, const Point& point, double shaker_place = 0.25);

/// Throws InputError for a scene with a drive that a periodic response cannot have.
Road periodic_road(const RoadContext& context);

/// Section evaluations that a point of the road will take, within a factor of three or so.
double expected_evaluations(const casefile::Scene& scene, const Point& point);

}  // namespace strandyn::study
