#pragma once
/// \file The integrator's own part in what is lost, against the bound that the case sets.

#include "plan.hpp"

namespace strandyn::study {

/// Of an account, over the last cycles or over the whole of a transient. [J]
struct ShareAccount {
  std::optional<double> share{};  ///< [-] nothing where nothing is dissipated
  double numerical = 0, quadrature_error = 0;
  std::size_t cycles = 0;  ///< of the run; 0 where it counts none
};

/// Ends the run with `not_converged` where its bound is broken, naming the steps that would hold it.
void check_numerical_share(const casefile::Scene& scene, const build::Integration& integration,
                           const VibrationPlan& plan, const ShareAccount& account, Outcome& outcome);

/// The columns of the losses that a scene can have.
std::vector<std::string> loss_columns(const casefile::Scene& scene);

/// `cost` of an integration, with a warning of steps that fell back to order 1.
void add_integration(const solver::IntegratorSummary& run, const system::System& system, Outcome& outcome);
void add_effort(const system::System& system, Cost& cost);

}  // namespace strandyn::study
