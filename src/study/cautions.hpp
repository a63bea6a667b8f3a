#pragma once
/// \file What to know before a number of a span is used: that its wires are beyond their strength, that the rest is not
/// the catenary, that a support jumps.

#include "strandyn/span/rest.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// [N] the largest axial force of a section at the state of the span.
double largest_tension(const span::SpanAtRest& span);

/// The largest tension of a state or of a path against the rated strength, where it is known, or against the strain at
/// which wires break. `when`: "at rest", "at the end of the path".
void warn_of_strength(const casefile::Scene& scene, const span::SpanAtRest& span, double tension, const char* when,
                      Outcome& outcome);

/// Both for a span that stands ready: its strength, and whether bending rules where the catenary is told beside it.
void warn_of_rest(const casefile::Scene& scene, const span::SpanAtRest& span, Outcome& outcome);

/// The largest jumps of velocity of supports and points that are moved, before the end [s] of a run: each is a blow,
/// whose friction depends on the step. True where there is one.
bool warn_of_blows(const build::BuiltSpan& built, std::span<const model::Drive> drives, double end, Outcome& outcome);

}  // namespace strandyn::study
