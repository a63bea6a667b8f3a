#pragma once
/// \file A test bench whose mesh, steps and points an accuracy chooses, point by point.
///
/// Mesh, steps and points by differences between whole benches (`accuracy`): what a step makes of the harmonics shows
/// in the steady state only. The bench comes near the amplitude only,
///     amplitude = n |A/A_wanted - 1|,   n = d ln loss/d ln A by trial cycles
/// and a tolerance that the case leaves open is made to fit.

#include "strandyn/self_damping/method.hpp"

namespace strandyn::study {

/// `scene` asks for an accuracy and must outlive the method.
std::unique_ptr<self_damping::Method> bench_to_target(const casefile::Scene& scene);

}  // namespace strandyn::study
