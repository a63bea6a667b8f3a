#pragma once
/// \file What a sweep and the choice of its accuracy share.

#include "strandyn/build/span.hpp"
#include "strandyn/casefile/scene.hpp"

namespace strandyn::study {

/// [Hz] that the drive of a sweep names, by a number or by a mode.
double drive_frequency(const casefile::Scene& scene, const build::BuiltSpan& built);

}  // namespace strandyn::study
