#pragma once
/// \file How a case is integrated in time: the method, its step, and what it will take from the motion by itself.

#include <span>
#include <string>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/solver/time/generalized_alpha.hpp"
#include "strandyn/solver/time/ida.hpp"

namespace strandyn::study {

/// What is asked of a step that the program chooses.
struct StepDemand {
  double frequency = 0;      ///< [Hz] highest of interest
  double damping_ratio = 0;  ///< [-] expected physical damping; 0: none, or not known
  double share = 0.01;       ///< [-] of the integrator in what is lost
};

/// Damping ratio of the scene's integrator for a mode of `frequency` [Hz] at a step [s].
double numerical_damping_ratio(const casefile::Integrator& integrator, double frequency, double step);

/// Steps per cycle that meet the demand; never so few that the motion itself is badly resolved.
int choose_steps_per_cycle(const casefile::Integrator& integrator, const StepDemand& demand);

solver::IntegratorSummary integrate(const casefile::Integrator& integrator, system::System& system,
                                    const solver::InitialMotion& initial, const solver::IntegratorOptions& options,
                                    std::span<observe::Observer* const> observers);

}  // namespace strandyn::study
