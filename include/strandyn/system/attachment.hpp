#pragma once
/// \file What hangs on a node of a chain and has unknowns and a memory of its own: a Stockbridge damper.
///
/// Over a step it is integrated by itself, from what the last commit left to the motion that the node is tried with at
/// the end. So its force is a function of a trial state, as the answer of a section law is: it may be asked as often as
/// a solver likes, and `commit` alone moves it on. It acts on states in motion; in a static analysis it is not there.

#include "strandyn/core/archive.hpp"
#include "strandyn/math/chain_matrix.hpp"

namespace strandyn::system {

struct State;

/// Energies after an accepted step. [J]
struct AttachedEnergy {
  double kinetic = 0;  ///< of the state
  double elastic = 0;  ///< of the state
  double lost = 0;     ///< in the step, >= 0
};

class Attachment {
 public:
  virtual ~Attachment() = default;
  /// f += what it asks of its node, for a trial state at a time [s]. [N], [N m]
  virtual void add_force(const State& state, double time, double* f) const = 0;
  /// K += about what the force changes with the motion of its node in the step of the last `add_force`: Newton's method
  /// takes fewer rounds with it.
  virtual void add_tangent(math::ChainMatrix& /*K*/) const {}
  /// Accepts the state as the end of a step.
  virtual AttachedEnergy commit(const State& state, double time) = 0;
  virtual void archive(Archive& a) = 0;
};

}  // namespace strandyn::system
