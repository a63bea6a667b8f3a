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

/// The condition that closes the system. Exactly one of the three controls.
struct Condition {
  Control control = Control::load;
  ControlledPoint point = {};  ///< displacement control, with the target of this step
  system::Vector base = {};    ///< arc length and drag: the state from which they count
  double arc = 0;              ///< [m]
  system::Vector drag = {};    ///< load control: [N/m], [N m] diagonal of a spring from each free unknown to `base`
  bool downhill = false;       ///< load control: no correction goes past the bottom of potential energy along it
};

struct NewtonResult {
  bool converged = false;
  bool is_rounding = false;  ///< the last correction was down at rounding
  int iterations = 0;
  double residual = 0;    ///< [N] largest
  std::size_t worst = 0;  ///< unknown that has it
  std::vector<double> corrections;
};

class PathNewton {
 public:
  PathNewton(const system::System& system, const EquilibriumOptions& options, Staging staging);

  NewtonResult iterate(PathPoint& point, const Condition& condition);
  /// Is the point a minimum of potential energy?
  bool is_minimum(const PathPoint& point);
  /// du/dlambda along the path at a point of it. Empty where the stiffness is singular.
  std::optional<system::Vector> direction(const PathPoint& point);

 private:
  struct Load {
    system::Vector force;  // free unknowns: f_ext; held ones: where they are to be
    system::Vector slope;  // their derivative by lambda
  };
  Load load_at(const PathPoint& point) const;
  system::At state(double factor) const;
  /// Derivative of potential energy, drag included, by a change of u. [J]
  double slope(const PathPoint& point, const Condition& condition, const system::Vector& along) const;
  /// The share of a correction that ends near the bottom of potential energy along it. Strands resist a change of
  /// curvature steeply at first and hardly later: whole steps may go to and fro across the bottom for ever.
  double step_downhill(const PathPoint& point, const Condition& condition, const system::Vector& correction) const;
  /// K_ -= d f_ext/du, the drag added and held unknowns held.
  void close(const PathPoint& point, const Condition& condition);
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
