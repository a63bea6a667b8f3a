#pragma once
/// \file What `describe` tells of a span, and what its vibration is expected to cost.

#include "plan.hpp"

namespace strandyn::study {

void add_span(const build::BuiltSpan& span, Outlook& outlook);

/// The plan, and the cost by half a cycle of the vibration at the amplitude that it will have.
void add_vibration(const casefile::Scene& scene, const VibrationPlan& plan, const build::Integration& integration,
                   span::SpanAtRest& span, Outlook& outlook);
/// The cost of `steps` steps from rest under the initial velocity, by the first of them.
void add_steps(double steps, const VibrationPlan& plan, const build::Integration& integration, span::SpanAtRest& span,
               Outlook& outlook);

/// [s] of one evaluation of a section, elements included, by a few evaluations of the forces of this very span.
double evaluation_time(const span::SpanAtRest& span);

/// [s] the same of `points` sections around a cycle of curvature in which wires slip, each step committed and asked for
/// forces.
struct SlippingCycle {
  double axial_strain = 0;
  double amplitude = 0.05;  ///< [1/m]
  int steps = 64;
  bool tangents = false;  ///< asked for tangents, too
};
double slipping_time(const section::Law& law, std::size_t points, const SlippingCycle& cycle);

/// [B] that the program holds at the moment.
double memory_in_use();

/// How far a count of section evaluations is known: from a part of it to a multiple.
void expect(Outlook& outlook, double evaluations, double within);

}  // namespace strandyn::study
