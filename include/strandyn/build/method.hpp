#pragma once
/// \file How a case is integrated in time: the method, the rule of its step, and what it takes from the motion by
/// itself.

#include <optional>
#include <span>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/solver/time/generalized_alpha.hpp"
#include "strandyn/solver/time/ida.hpp"

namespace strandyn::build {

/// What is asked of a step that the program chooses.
struct StepDemand {
  double frequency = 0;      ///< [Hz] highest of interest
  double damping_ratio = 0;  ///< [-] expected physical damping; 0: none, or not known
  double share = 0.01;       ///< [-] of the integrator in what is lost
};

class Integration {
 public:
  /// Throws InputError for what the method cannot do.
  explicit Integration(const casefile::Scene& scene);

  bool chooses_steps() const { return keys_.step == casefile::StepRule::automatic; }
  bool controls_error() const { return keys_.step == casefile::StepRule::adaptive; }
  double relative_error() const { return keys_.rtol; }
  /// [s] as given, or of a cycle of `frequency` [Hz].
  double step_at(double frequency) const;

  /// Damping ratio that the method gives a mode of `frequency` [Hz] at a step [s].
  double damping_ratio(double frequency, double step) const;
  /// Steps per cycle that meet the demand; never so few that the motion itself is badly resolved.
  int choose_steps_per_cycle(const StepDemand& demand) const;
  /// How many times more steps bring the remainder of an account below `allowed` [J]. The method's own damping falls
  /// with the third power of the step (IDA) or the second (energy error of the trapezoidal rule). The quadrature error
  /// is part of the remainder, with a minus; it falls a little faster than with the first power, since slip begins and
  /// ends within steps.
  double more_steps(double numerical, double quadrature_error, double allowed) const;

  solver::IntegratorOptions options(double step, double end_time) const;
  solver::IntegratorSummary run(system::System& system, const solver::InitialMotion& initial,
                                const solver::IntegratorOptions& options,
                                std::span<observe::Observer* const> observers) const;

 private:
  casefile::Integrator keys_;
};

}  // namespace strandyn::build
