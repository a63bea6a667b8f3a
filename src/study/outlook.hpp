#pragma once
/// \file What `describe` tells of a span, and what its vibration is expected to cost.

#include "plan.hpp"

namespace strandyn::study {

void add_span(const build::BuiltSpan& span, Outlook& outlook);

/// The plan, and the cost by half a cycle of the vibration at the amplitude that it will have.
void add_vibration(const VibrationPlan& plan, const build::Integration& integration, span::SpanAtRest& span,
                   Outlook& outlook);
/// The cost of `steps` steps from rest under the initial velocity, by the first of them.
void add_steps(double steps, const VibrationPlan& plan, const build::Integration& integration, span::SpanAtRest& span,
               Outlook& outlook);

/// [s] of one evaluation of a section, elements included, by a few evaluations of the forces of this very span.
double evaluation_time(const span::SpanAtRest& span);

/// [B] that the program holds at the moment.
double memory_in_use();

/// How far a count of section evaluations is known: from a part of it to a multiple.
void expect(Outlook& outlook, double evaluations, double within);

}  // namespace strandyn::study
