#pragma once
/// \file One cycle of a vibration, as a reader looks at it: the span at some moments.

#include "strandyn/observe/fundamental.hpp"
#include "strandyn/span/rest.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// motion.csv and its figure: the fundamental of the last cycle at evenly spaced phases, across the span in the
/// direction that moves most. Nothing before a cycle has ended.
void add_motion(const span::SpanAtRest& span, const observe::Fundamental& fundamental, Outcome& outcome);

}  // namespace strandyn::study
