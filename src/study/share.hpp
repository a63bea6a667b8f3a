#pragma once
/// \file The integrator's own part in what is lost, against the bound that the case sets.

#include "plan.hpp"
#include "strandyn/observe/cycles.hpp"

namespace strandyn::study {

/// Of an account: means over the last cycles, or the whole of a transient. [J]
struct ShareAccount {
  double numerical = 0, quadrature_error = 0;
  double lost = 0;         ///< by all that physics takes
  double energy = 0;       ///< the greatest that the span had
  double stored = 0;       ///< by the tension at rest
  bool has_blows = false;  ///< the velocity of a support jumps: its impulse does work in no time, which no step sees
  std::size_t cycles = 0;  ///< of the run; 0 where it counts none
};

/// Ends the run with `not_converged` where its bound is broken, naming the steps that would hold it. The bound is a
/// part of what is lost over the last `cycles_of_default_share` cycles. A run of fewer cycles or none, and one that
/// loses nothing, has the larger of its loss and of `part_of_energy` of its greatest energy in the place of the loss: a
/// span that has hardly begun to move has lost hardly anything.
void check_numerical_share(const casefile::Scene& scene, const build::Integration& integration,
                           const VibrationPlan& plan, const ShareAccount& account, Outcome& outcome);

/// [J] how much energy is on its way. Elastic energy is above that of the start, which may be loaded: a span that is
/// let go gives it back.
double energy_of(double kinetic, double elastic);

/// The means of the last cycles of a run.
ShareAccount account_of(const build::BuiltSpan& span, const observe::CycleObserver& cycles, std::size_t last);

/// [J] what the tension of the span has stored.
double stored_by_tension(const build::BuiltSpan& span);

/// The columns of the losses that a scene can have.
std::vector<std::string> loss_columns(const casefile::Scene& scene);

/// `cost` of an integration, with a warning of steps that fell back to order 1.
void add_integration(const solver::IntegratorSummary& run, const system::System& system, Outcome& outcome);
void add_effort(const system::System& system, Cost& cost);

}  // namespace strandyn::study
