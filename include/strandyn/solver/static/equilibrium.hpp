#pragma once
/// \file Static equilibrium f_int(u) = dead loads + lambda * live loads by Newton's method, in steps with cut-back.
///
/// Three ways to go along the path (u, lambda):
///     load           lambda in equal steps up to 1
///     displacement   d . u of one node in equal steps; lambda is what it takes            passes limit points of load
///     arc length     |change of all displacements| per step, lambda follows               passes limit points of both
/// Each Newton correction is du = K^-1 r + dlambda K^-1 p with p = d(load)/d(lambda); dlambda fulfils the linearized
/// condition of the control. [Crisfield 1991, ch. 9]
///
/// Every step is committed: friction depends on the path.

#include <functional>
#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/core/words.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::solver {

using strandyn::Control;

/// What displacement control leads to its target.
struct ControlledPoint {
  std::size_t node = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();
  double target = 0;  ///< [m] along the direction, at the last step
};

/// One step that has converged.
struct EquilibriumStep {
  double load_factor = 0;
  int iterations = 0;
  double residual = 0;                ///< [N] largest
  std::vector<double> corrections;    ///< [m, rad] Euclidean norms of the Newton corrections
  std::size_t sections_slipping = 0;  ///< section points in which friction was dissipated in this step
};

struct EquilibriumOptions {
  int steps = 1;                      ///< equal steps; under arc length the most that are taken
  int max_iterations = 30;            ///< per step
  double tolerance = 1e-10;           ///< residual relative to the largest force at work
  double smallest_step = 1.0 / 1024;  ///< of a step, before it gives up
  Control control = Control::load;
  ControlledPoint point = {};  ///< displacement control
  double arc_step = 0;         ///< [m] Euclidean norm of all displacements; 0: that of a load step of 1/steps
  double max_load_factor = 1;  ///< load: where the path ends; arc length: it ends when it first passes this
  Stop stop = {};              ///< asked after each step: true ends the path early
  /// Told of each step after its commit, with the state and the share of the path that is done.
  std::function<void(const EquilibriumStep&, const system::Vector& u, double done)> watch = {};
};

struct EquilibriumSummary {
  std::vector<EquilibriumStep> steps;
  bool stopped = false;
};

/// Goes along the path from `u`, which is in equilibrium under the dead loads alone. Throws ComputationError that names
/// step, node and residual.
EquilibriumSummary find_equilibrium(system::System& system, system::Vector& u, const EquilibriumOptions& options);

/// Has the equilibrium at u, under `part` of the live loads, no direction in which the chain would run away?
bool is_stable(const system::System& system, const system::Vector& u, double part);

/// How a chain finds the shape in which it hangs under its dead loads.
struct RestingShape {
  system::Vector guess;     ///< near the shape that is looked for
  system::Vector straight;  ///< where the guess does not lead there: a straight, slightly taut state, supports included
};

/// The state under the dead loads, its sections bent in one step from the straight: `system` begins its history there.
/// From the guess, or else from the straight chain: the dead loads step by step, then the supports to their places.
/// Only stable states are accepted on the way.
system::Vector find_rest(system::System& system, const RestingShape& shape);

}  // namespace strandyn::solver
