#pragma once
/// \file What a scene does: forces, tangents and energies of the chain, and the history of its sections.
///
///     M(u) v' + g(u, v) + f_int(u; history) + c v = f_ext(t)
/// with u the displacements and rotations of all nodes, supports included: a held unknown keeps its place in the
/// vectors, its equation reads u = 0. Unknowns without mass (rotations, unless they carry rotary inertia) are
/// algebraic.
///
/// Everything but `begin` and `commit` is const in the committed history: the integrator may evaluate states that it
/// throws away. `commit` re-evaluates the section law at the state it is given and is the only writer of history.
/// An object serves one thread: evaluations share working storage.

#include <Eigen/Dense>

#include "strandyn/core/stopwatch.hpp"
#include "strandyn/math/block_tridiagonal.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::system {

using Vector = Eigen::VectorXd;
using ConstVectorRef = Eigen::Ref<const Vector>;
using VectorRef = Eigen::Ref<Vector>;
using Matrix = math::BlockTridiagonal<static_cast<int>(model::unknowns_per_node)>;

/// Energies of the chain after an accepted step. [J]
struct Accepted {
  double elastic = 0;           ///< stored in all sections
  double friction = 0;          ///< dissipated by friction in the step, >= 0
  double quadrature_error = 0;  ///< excess of `friction` over the trapezoidal work balance of the step, >= 0
};

/// Velocities and accelerations that go with a position.
struct Motion {
  const double* u = nullptr;
  const double* v = nullptr;
  const double* a = nullptr;
};

/// How much of each derivative of the inertia and drag forces a matrix takes.
struct InertiaFactors {
  double acceleration = 0;  ///< of the mass matrix
  double velocity = 0;      ///< of d/dv
  double position = 0;      ///< of d/du
};

class System {
 public:
  explicit System(const model::Model& model);

  const model::Model& model() const { return model_; }
  std::size_t unknowns() const { return model_.unknowns(); }
  bool is_held(std::size_t i) const { return held_[i]; }
  bool has_mass(std::size_t i) const { return mass_[i]; }  ///< is the unknown dynamic: free, and with inertia

  /// Starts the history: virgin sections, brought straight to the strains of `u`.
  void begin(const ConstVectorRef& u);

  /// f = f_int(u). [N], [N m]
  void internal_force(const double* u, double* f) const;
  /// The same and K = df_int/du.
  void internal_force(const double* u, double* f, Matrix& K) const;
  /// f = f_ext(t).
  void external_force(double t, double* f) const;
  /// f += M v' + g + c v.
  void add_inertia_and_drag(const Motion& motion, double* f) const;
  /// K += the derivatives of M v' + g + c v by acceleration, velocity and position, each times its factor.
  void add_inertia_and_drag(const Motion& motion, InertiaFactors factors, Matrix& K) const;
  /// Replaces the equations of held unknowns by u = right-hand side.
  void hold(Matrix& K) const;

  double kinetic_energy(const double* u, const double* v) const;  ///< [J]
  double drag_power(const double* v) const;                       ///< [W] v . c v
  /// M a = f for the unknowns with mass, all others 0: consistent initial accelerations.
  void accelerations(const double* u, const double* v, const double* force, double* a) const;
  /// The mass matrix at u, held unknowns included.
  void mass_matrix(const double* u, Matrix& M) const;

  /// Accepts u as the end of a step.
  Accepted commit(const double* u);

  /// Per section point, two per element, of the last commit. [J/m of unstressed length]
  const section::StepEnergy& step_energy() const { return energy_; }
  /// Curvature [1/m] and axial strain [-] per section point of the last commit.
  const section::Field& committed_strains() const { return committed_; }
  /// [m] unstressed length that the section point stands for.
  double point_length(std::size_t point) const {
    return beam::gauss_weight * model_.elements[point / beam::gauss_points].length;
  }

  section::Effort effort() const { return effort_; }
  std::size_t residual_evaluations() const { return residual_evaluations_; }
  std::size_t jacobian_evaluations() const { return jacobian_evaluations_; }
  Stopwatch& stopwatch() const { return stopwatch_; }

 private:
  void find_strains(const double* u) const;
  void assemble(double* f, Matrix* K) const;

  const model::Model& model_;
  std::vector<bool> held_, mass_;
  Vector lumped_;  // [kg], [kg m^2] diagonal mass; lumped scenes only
  Vector drag_;    // [N s/m] per unknown
  section::History history_;
  section::StepEnergy energy_;
  section::Field committed_;

  // Working storage of an evaluation.
  mutable std::vector<beam::PlanarKinematics> kinematics_;
  mutable section::Field strains_, stresses_;
  mutable section::TangentField tangents_;
  mutable section::Effort effort_;
  mutable std::size_t residual_evaluations_ = 0;
  mutable std::size_t jacobian_evaluations_ = 0;
  mutable Stopwatch stopwatch_;
};

}  // namespace strandyn::system
