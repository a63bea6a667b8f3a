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

#include <span>

#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::solver {

/// Can a run be kept midway? IDA has no public way out for its memory, and its private header is not everywhere.
bool ida_has_checkpoints();

/// Integrates from time 0; steps grow to `options.step` by doubling from 1/256 of it. The history of `system` must have
/// begun at `initial.u`. Throws InputError where checkpoints are asked for and there are none.
IntegratorSummary integrate_ida(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
                                std::span<observe::Observer* const> observers);

}  // namespace strandyn::solver
