#pragma once
/// \file Newton's method for one step of an equilibrium path: state, load factor and one condition on both.

#include <optional>

#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::solver {

/// A point of the path.
struct PathPoint {
  system::Vector u;
  double factor = 0;  ///< lambda
};

/// What goes from nothing to all of it while lambda goes from 0 to 1.
enum class Stage {
  live,     ///< live loads and prescribed motions, under all dead loads
  dead,     ///< dead loads alone; held unknowns stay where they start
  supports  ///< held unknowns, from where they start to their places, under all dead loads
};

struct Staging {
  Stage stage = Stage::live;
  system::Vector held_start = {};  ///< all unknowns; stages `dead` and `supports`
};

/// The condition that closes the system. Exactly one of the three.
struct Condition {
  Control control = Control::load;
  ControlledPoint point = {};  ///< displacement control, with the target of this step
  system::Vector base = {};    ///< arc length: the state from which it counts
  double arc = 0;              ///< [m]
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0;    ///< [N] largest
  std::size_t worst = 0;  ///< unknown that has it
  std::vector<double> corrections;
};

class PathNewton {
 public:
  PathNewton(const system::System& system, const EquilibriumOptions& options, Staging staging);

  NewtonResult iterate(PathPoint& point, const Condition& condition);
  /// du/dlambda along the path at a point of it. Empty where the stiffness is singular.
  std::optional<system::Vector> direction(const PathPoint& point);

 private:
  struct Load {
    system::Vector force;  // free unknowns: f_ext; held ones: where they are to be
    system::Vector slope;  // their derivative by lambda
  };
  Load load_at(const PathPoint& point) const;
  system::At state(double factor) const;
  bool is_rounding(const system::Vector& correction, const system::Vector& u) const;

  const system::System& system_;
  const EquilibriumOptions& options_;
  Staging staging_;
  system::Matrix K_;
  math::ChainFactors factors_;
};

/// Translations of all nodes, rotations zero: what an arc is measured by.
system::Vector translations(const model::Model& model, const system::Vector& u);

}  // namespace strandyn::solver
