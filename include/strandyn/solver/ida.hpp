#pragma once
/// \file Time integration with SUNDIALS IDA, held to the second-order BDF formula at a bounded step.
///
///     y = (u, v):   F = (u' - v,  M v' + g + c v + f_int(u; committed history) - f_ext(t))
/// for unknowns with mass; v = 0 for those without, u = 0 and v = 0 for held ones. The residual is pure in the
/// committed history, which moves on once per accepted step by re-evaluation at the state that IDA returns.
///
/// Why not IDA's defaults: orders 3 to 5 are unstable for undamped mesh modes; slip kinks make the order controller
/// fall to order 1 (damping omega h/2) and the Newton test, which remembers the rate of older steps, accept a first
/// iterate. So the order is held at 2 (the error test sees a constant; accuracy is governed by the step and shown by
/// the energy ledger), and the Newton test uses the current step only. Damping of a mode: zeta = (omega h)^3/4;
/// relative error of its frequency: (omega h)^2/3. [H2005, B1996]

#include <functional>
#include <memory>
#include <span>

#include "strandyn/solver/step_record.hpp"

namespace strandyn::solver {

struct IdaOptions {
  double step = 0;                 ///< [s] bound of the step; reached by doubling from step/256
  double end_time = 0;             ///< [s]
  double newton_tolerance = 1e-9;  ///< Euclidean norm of a Newton correction of u [m, rad]
  int max_newton_iterations = 12;  ///< per step, before the step is cut
  std::function<bool()> stop;      ///< asked after each step: true ends the run early
};

enum class Ending { finished, stopped, failed };

struct IdaSummary {
  Ending ending = Ending::finished;
  std::size_t steps = 0;
  std::size_t rejected_steps = 0;   ///< cut because Newton did not converge
  std::size_t order_one_steps = 0;  ///< after the start
  std::size_t newton_iterations = 0;
  double end_time = 0;  ///< [s] reached
  std::string failure;  ///< what went wrong, where: time, step, worst unknowns
};

/// Initial motion: u in equilibrium or not, velocities; rates of unknowns without mass only help the first step.
struct InitialMotion {
  system::Vector u;
  system::Vector v;
};

/// Integrates from time 0. The history of `system` must have begun at `initial.u`.
IdaSummary integrate_ida(system::System& system, const InitialMotion& initial, const IdaOptions& options,
                         std::span<Observer* const> observers);

}  // namespace strandyn::solver
