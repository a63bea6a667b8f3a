#pragma once
/// \file How a case is integrated in time: the method of its keys.

#include "strandyn/casefile/scene.hpp"
#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::study {

/// As the keys of [integrator] say.
solver::TimeMethod method_of(const casefile::Integrator& integrator);

/// [rad] of a motion of `frequency` [Hz] per step [s].
double angle_per_step(double frequency, double step);

}  // namespace strandyn::study
