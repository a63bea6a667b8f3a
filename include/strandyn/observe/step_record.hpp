#pragma once
/// \file What an integrator tells of every accepted step, and who may listen.

#include "strandyn/core/archive.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::observe {

/// Valid during the call only: whoever wants to keep something copies it. Within a run u, v and a are the same vectors
/// in every call, that of `begin` included.
struct StepRecord {
  double time = 0;  ///< [s] at the end of the step
  double step = 0;  ///< [s] its length; 0 for the initial state
  int order = 0;
  const system::Vector& u;  ///< displacements [m] and rotations [rad]
  const system::Vector& v;  ///< velocities; 0 for unknowns without mass
  const system::Vector& a;  ///< accelerations; 0 for unknowns without mass
  /// [N], [N m] of this state under the committed history, as `System::forces` tells them; empty where no observer of
  /// the run wants them.
  const system::Vector& external;
  const system::Vector& internal;
  system::Accepted accepted;
};

/// Sees the initial state and every accepted step, after the commit.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void begin(const system::System& system, const StepRecord& initial) = 0;
  virtual void step(const system::System& system, const StepRecord& record) = 0;
  /// Between two steps rotation vectors were exchanged for those of the same rotations by the other way round: the
  /// state of the last step in the coordinates from which the next one counts. Whoever takes differences of them begins
  /// anew here.
  virtual void exchanged(const StepRecord&) {}
  /// Does it read the forces of the record?
  virtual bool wants_forces() const { return false; }
  /// What it has gathered, for checkpoints: written, or read after `begin`. Whoever gathers nothing does nothing.
  virtual void archive(Archive&) { throw ComputationError("an observer of this run cannot be kept in a checkpoint"); }
};

}  // namespace strandyn::observe
