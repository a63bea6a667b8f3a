#pragma once
/// \file The dampers of a scene, hung on its span.

#include "strandyn/span/rest.hpp"

namespace strandyn::study {

/// Their metal loses at `frequency` [Hz]. The masses of their clamps are on the span already.
void hang_dampers(const casefile::Scene& scene, double frequency, span::SpanAtRest& span);

}  // namespace strandyn::study
