#pragma once
/// \file Integration in time: one loop over the steps of whichever method.
///
///     M(u) v' + g(u, v) + f_int(u; committed history) + c v = f_ext(t, u),   u' = v
/// for unknowns with mass, f_int = f_ext for those without, u as prescribed for held ones. The history moves on once
/// per accepted step, by re-evaluation at the state of its end.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/observe/step_record.hpp"
#include "strandyn/solver/time/method.hpp"

namespace strandyn::solver {

/// The state of a run, kept midway and taken up again. A run that goes on from there equals, to the bit, the one that
/// was never interrupted: history of the sections, of the integrator and its factors, counters and observers included.
struct Checkpoints {
  std::function<bool()> due = {};                     ///< asked after each step, after `stop`
  std::function<void(const std::string&)> keep = {};  ///< told the state where it is due
  /// A state that was kept of the same run, to go on from; empty: from the start. What is no such state is refused with
  /// an InputError or a FileError.
  std::string resume = {};
};

struct IntegratorOptions {
  double step = 0;      ///< [s] whole multiples of it are met, cycle ends among them
  double end_time = 0;  ///< [s]
  /// Euclidean norm of a Newton correction of u [m, rad]. What is left of it is force along stiff axial unknowns, and
  /// feeds or takes energy cycle by cycle: 1e-9 takes and gives damping ratios of 4e-7 on a laboratory span.
  double newton_tolerance = 1e-12;
  int max_newton_iterations = 12;  ///< per step, before the step is cut
  /// IDA only: above 0, its own control of the error of a step, relative to the largest motion so far; `step` is then
  /// a bound. Cycle ends fall inside steps. 0: all steps are alike.
  double relative_error = 0;
  /// [Hz] generalized-alpha only: what its steps are fitted to (`GeneralizedAlpha::stretch`). 0: nothing.
  double fitted_frequency = 0;
  Stop stop = {};  ///< asked after each step: true ends the run early
  Checkpoints checkpoints = {};
  std::vector<model::Drive> drives = {};  ///< what `model::Driven` loads and motions follow
};

enum class Ending { finished, stopped, failed };

struct IntegratorSummary {
  Ending ending = Ending::finished;
  std::size_t steps = 0;
  std::size_t rejected_steps = 0;   ///< cut because Newton did not converge
  std::size_t order_one_steps = 0;  ///< after the start; a one-step method has none
  std::size_t newton_iterations = 0;
  double end_time = 0;  ///< [s] reached
  std::string failure;  ///< what went wrong, where: time, step, worst unknowns
};

/// Initial motion: u in equilibrium or not, velocities; rates of unknowns without mass only help the first step.
struct InitialMotion {
  system::Vector u;
  system::Vector v;
};

/// Integrates from time 0. The history of `system` must have begun at `initial.u`. Checkpoints that the method cannot
/// keep are an InputError.
IntegratorSummary integrate(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
                            const TimeMethod& method, std::span<observe::Observer* const> observers);

}  // namespace strandyn::solver
