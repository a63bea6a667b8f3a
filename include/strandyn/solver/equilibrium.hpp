#pragma once
/// \file Static equilibrium f_int(u) = factor * f_ext by Newton's method with load steps and cut-back.

#include <vector>

#include "strandyn/system/system.hpp"

namespace strandyn::solver {

struct EquilibriumOptions {
  int steps = 1;                      ///< equal load steps
  int max_iterations = 30;            ///< per load step
  double tolerance = 1e-10;           ///< residual relative to the largest force at work
  double smallest_step = 1.0 / 1024;  ///< of a load step, before it gives up
};

/// One load step that has converged.
struct EquilibriumStep {
  double load_factor = 0;
  int iterations = 0;
  double residual = 0;                ///< [N] largest
  std::size_t sections_slipping = 0;  ///< section points in which friction was dissipated in this step
  system::Vector u;                   ///< [m], [rad]
};

struct EquilibriumSummary {
  std::vector<EquilibriumStep> steps;
};

/// Finds u from the given start and commits each load step. Throws ComputationError that names step, node and residual.
EquilibriumSummary find_equilibrium(system::System& system, system::Vector& u, const EquilibriumOptions& options);

}  // namespace strandyn::solver
