#pragma once
/// \file What both integrators do with checkpoints; `Run` is the integrator's own part of the state.

#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::solver {

template <class Run>
void archive_run(Archive& a, system::System& system, Run& run, std::span<observe::Observer* const> observers) {
  a.same(system.unknowns(), "number of unknowns");
  a.same(std::string(system.model().law->name()), "section law");
  a.same(observers.size(), "number of observers");
  a(run, system);  // in this order: IDA's first step, which makes it ready to read, belongs to the initial history
  for (observe::Observer* observer : observers) observer->archive(a);
}

/// After a step.
template <class Run>
void keep_checkpoint(const Checkpoints& checkpoints, system::System& system, Run& run,
                     std::span<observe::Observer* const> observers) {
  if (!checkpoints.due || !checkpoints.due()) return;
  Archive a;
  archive_run(a, system, run, observers);
  checkpoints.keep(a.bytes());
}

/// After the beginning, which every run makes in the same way: sizes are then what they will be.
template <class Run>
void resume(const Checkpoints& checkpoints, system::System& system, Run& run,
            std::span<observe::Observer* const> observers) {
  if (checkpoints.resume.empty()) return;
  Archive a(checkpoints.resume);
  archive_run(a, system, run, observers);
  a.finish();
}

}  // namespace strandyn::solver
