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
///
/// Steps grow to the wanted one by doubling from 1/256 of it.

namespace strandyn::solver {

struct Ida {
  static constexpr const char* name = "ida";
  static constexpr int least_steps = 400;  ///< a cycle: its error is that of generalized-alpha at half the steps

  /// Leading terms for a mode of angle omega h [rad] per step.
  double damping_ratio(double angle) const;
  double frequency_error(double angle) const;  ///< relative
};

/// Can a run of IDA be kept and taken up again? Only where the program was built with the header of IDA's memory, which
/// not every installation of SUNDIALS has. Checkpoints of generalized-alpha always work.
bool ida_has_checkpoints();

}  // namespace strandyn::solver
