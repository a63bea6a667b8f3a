#pragma once
/// \file The methods of integration as values: what each does to a mode, and the steps that keep it small.
///
/// A third method is an entry of the list, a header like those of the others, and a stepper.

#include <variant>

#include "strandyn/solver/time/generalized_alpha.hpp"
#include "strandyn/solver/time/ida.hpp"

namespace strandyn::solver {

using TimeMethod = std::variant<Ida, GeneralizedAlpha>;

const char* name_of(const TimeMethod& method);

/// What the method does by itself to a mode of angle omega h [rad] per step.
double damping_ratio(const TimeMethod& method, double angle);
double frequency_error(const TimeMethod& method, double angle);  ///< relative

/// What is asked of a step.
struct StepDemand {
  double damping_ratio = 0;  ///< [-] expected physical damping; 0: none, or not known
  double share = 0.01;       ///< [-] of the method in what is lost
};

/// Steps per cycle, in fours, that meet the demand; never so few that the motion itself is badly resolved.
int steps_for(const TimeMethod& method, const StepDemand& demand);

}  // namespace strandyn::solver
