#pragma once
/// \file How a case is integrated in time: the method, the rule of its step, and what it takes from the motion by
/// itself.

#include "strandyn/casefile/scene.hpp"
#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::build {

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
  /// How many times more steps bring the remainder of an account below `allowed` [J]. The method's own damping falls
  /// with the third power of the step (IDA) or the second (energy error of the trapezoidal rule). The quadrature error
  /// is part of the remainder, with a minus; it falls a little faster than with the first power, since slip begins and
  /// ends within steps.
  double more_steps(double numerical, double quadrature_error, double allowed) const;

  /// `frequency` [Hz]: of the drive or of the mode, to which steps are fitted where the case asks for it; 0: none.
  solver::IntegratorOptions options(double step, double end_time, std::vector<model::Drive> drives = {},
                                    double frequency = 0) const;
  const solver::TimeMethod& method() const { return method_; }

 private:
  casefile::Integrator keys_;
  solver::TimeMethod method_;
};

}  // namespace strandyn::build
