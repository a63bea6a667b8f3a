#pragma once
/// \file What a scene does: forces, tangents and energies of the chain, and the history of its sections.
///
///     r(u, v, v'; t, drives) = M(u) v' + g(u, v) + f_int(u; history) + C v + F_air(v) - F_wind(u, v, v')
///                              + F_hung(u, v, v') - f_ext(t, u; drives) = 0
/// with u the displacements and rotations of all nodes, supports included: a held unknown keeps its place in the
/// vectors, its equation reads u = 0, or u = what a prescribed motion says. Unknowns without mass (rotations, unless
/// they carry rotary inertia) are algebraic.
///
/// Everything but `begin` and `commit` is const in the committed history: the integrator may evaluate states that it
/// throws away. `commit` re-evaluates the section law at the state it is given and is the only writer of history.
/// An object serves one thread: evaluations share working storage.
///
/// **Material damping** (section/material_damping.hpp) knows time: its branches answer the strain since the last commit
/// in the time since then. The clock begins with `start_clock`; until then, in a static analysis, they are relaxed.

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/core/archive.hpp"
#include "strandyn/core/stopwatch.hpp"
#include "strandyn/math/chain_matrix.hpp"
#include "strandyn/model/model.hpp"
#include "strandyn/section/material_damping.hpp"
#include "strandyn/system/air_on_chain.hpp"
#include "strandyn/system/attachment.hpp"
#include "strandyn/system/eccentric_bodies.hpp"
#include "strandyn/system/wind.hpp"

namespace strandyn::system {

using Vector = Eigen::VectorXd;
using ConstVectorRef = Eigen::Ref<const Vector>;
using Matrix = math::ChainMatrix;

class Chain;

/// Energies of the chain after an accepted step. [J]
struct Accepted {
  double elastic = 0;           ///< stored in all sections, material branches and springs, above that of `begin`
  double friction = 0;          ///< dissipated by friction in the step, >= 0
  double material = 0;          ///< dissipated by the metal in the step, >= 0
  double quadrature_error = 0;  ///< excess of both over the trapezoidal work balance of the step; of friction >= 0
  double attached = 0;          ///< dissipated in the step by what hangs on the chain, >= 0
  double attached_kinetic = 0;  ///< kinetic energy of that; its elastic energy is in `elastic`
};

/// Positions, and the velocities and accelerations that go with them; without these it is a state at rest.
struct State {
  const double* u = nullptr;
  const double* v = nullptr;
  const double* a = nullptr;

  bool is_at_rest() const { return !v; }
};

/// How much of each derivative of the inertia and drag forces a matrix takes.
using beam::InertiaFactors;

/// Viscous damping that is made from the chain itself, about its state of rest: forces C v with constant C.
struct ProportionalDamping {
  /// A mode's share: factor (momentum . v) momentum, with momentum = M phi and factor = 2 zeta omega/(phi . M phi).
  struct Mode {
    Vector momentum;
    double factor = 0;
  };
  std::optional<Matrix> rayleigh;  ///< a M + b K; held unknowns take no part
  std::vector<Mode> modes;
};

/// What the viscous forces take, each under its own name. [W], or [J] once summed over time. To add a term: a member,
/// its line in `viscous_terms`, its power in `System::viscous_power`.
struct ViscousLoss {
  double drag = 0, dampers = 0, rayleigh = 0, modal = 0;

  double total() const;
};
struct ViscousTerm {
  double ViscousLoss::*value;
  const char* name;  ///< in the account of a cycle, with its unit
  const char* what;
};
inline constexpr ViscousTerm viscous_terms[] = {{&ViscousLoss::drag, "drag_J", "of it, drag along the span"},
                                                {&ViscousLoss::dampers, "dampers_J", "of it, dampers of bodies"},
                                                {&ViscousLoss::rayleigh, "rayleigh_J", "of it, Rayleigh damping"},
                                                {&ViscousLoss::modal, "modal_J", "of it, modal damping"}};

/// Term by term: `value_of(member)`.
template <class F>
ViscousLoss of_each_term(const F& value_of) {
  ViscousLoss loss;
  for (const ViscousTerm& term : viscous_terms) loss.*term.value = value_of(term.value);
  return loss;
}
inline double ViscousLoss::total() const {
  double sum = 0;
  for (const ViscousTerm& term : viscous_terms) sum += this->*term.value;
  return sum;
}

/// When loads and prescribed motions are asked for: at a time, in a static analysis in part, in a run under its drives.
struct At {
  double time = 0;  ///< [s]
  double part = 1;  ///< [-] of all loads and motions but the dead loads
  double dead = 1;  ///< [-] of the dead loads
  std::span<const model::Drive> drives = {};
};

class System {
 public:
  explicit System(const model::Model& model);
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  const model::Model& model() const { return model_; }
  std::size_t unknowns() const { return held_.size(); }
  Matrix make_matrix() const { return {static_cast<int>(model_.unknowns_per_node()), model_.nodes.size()}; }
  Vector make_vector() const { return Vector::Zero(static_cast<Eigen::Index>(unknowns())); }

  bool is_held(std::size_t i) const { return held_[i]; }
  bool has_mass(std::size_t i) const { return mass_[i]; }  ///< is the unknown dynamic: free, and with inertia
  bool has_moving_supports() const { return !model_.motions.empty(); }
  /// Writes the values that held unknowns have; leaves the others.
  void held_values(At at, double* u) const;
  void held_rates(At at, double* v) const;

  /// Adds damping that needs modes or the stiffness at rest, and so cannot be part of the model.
  void set_damping(ProportionalDamping damping) { damping_ = std::move(damping); }
  const ProportionalDamping& damping() const { return damping_; }

  /// From here on still air acts as it does on a swing of this frequency [Hz], where the model has air around it.
  void set_swing(double frequency);
  /// What acts; none before the swing is known.
  const air::AirForce& air() const { return air_; }
  const AirOnChain& air_on_chain() const { return air_on_chain_; }

  /// From here on this wind acts on states in motion. In a static analysis there is none.
  void set_wind(std::unique_ptr<WindOnChain> wind) { wind_ = std::move(wind); }
  /// From here on this hangs on the chain.
  void attach(std::unique_ptr<Attachment> attachment) { attached_.push_back(std::move(attachment)); }
  /// f += what hangs on the chain asks of it, less what the wind gives: internal forces of a state in motion.
  void add_attached_force(const State& state, double time, double* f) const;

  /// Starts the history: virgin sections, brought straight to the strains of `u`. The clock stands.
  void begin(const ConstVectorRef& u);
  /// From here on the material damping counts time: the last commit was at `time` [s].
  void start_clock(double time) { clock_ = time; }

  /// r = M v' + g + C v + f_int - f_ext for all unknowns. At held ones, whose own equation is another, it is what the
  /// support does; at all others it is zero where the equation of motion holds. A state at rest has no inertia and
  /// drag.
  void residual(const State& state, At at, double* r) const;
  /// The same and K = d(f_int - f_ext)/du, the law asked once.
  void residual(const State& state, At at, double* r, Matrix& K) const;
  /// What the supports do: the residual at held unknowns, zero at all others. [N], [N m]
  void reactions(const State& state, At at, double* f) const;
  /// The two forces of an accepted state, apart. Where supports move, `external` has at held unknowns what loads and
  /// support have to do together.
  void forces(const State& state, At at, Vector& external, Vector& internal) const;

  /// f = f_int(u) at rest, springs of bodies included. [N], [N m]
  void internal_force(const double* u, double* f) const;
  /// The same and K = df_int/du.
  void internal_force(const double* u, double* f, Matrix& K) const;
  /// The three parts of these, for solvers that ask the law themselves with a history of their own: strains at u, and
  /// the forces and the stiffness of a chain whose sections carry given resultants.
  void strains(const double* u, section::Field& strains) const;
  void internal_force_of(const section::Field& stresses, const double* u, double* f) const;
  void stiffness_of(const section::Field& stresses, const section::TangentField& tangents, const double* u,
                    Matrix& K) const;
  /// f = f_ext at u: moments that keep their direction in space depend on the rotation of their node.
  void external_force(At at, const double* u, double* f) const;
  /// K -= df_ext/du.
  void subtract_external_tangent(At at, const double* u, Matrix& K) const;
  /// f += M v' + g + C v + F_air, with all viscous forces.
  void add_inertia_and_drag(const State& state, double* f) const;
  /// K += the derivatives of M v' + g + C v + F_air by acceleration, velocity and position, each times its factor.
  /// Modal damping, which couples all nodes and is small beside the inertia of a step, is left out.
  void add_inertia_and_drag(const State& state, InertiaFactors factors, Matrix& K) const;
  /// Replaces the equations of held unknowns by u = right-hand side.
  void hold(Matrix& K) const;

  double kinetic_energy(const double* u, const double* v) const;  ///< [J]
  /// [J] above that of `begin`: of sections that store so much [J/m] each, of the metal and of the springs. Summed up
  /// as differences: the tension stores a thousand million times what a small vibration moves.
  double elastic_energy(const AlignedVector& stored, const double* u) const;
  ViscousLoss viscous_power(const double* v) const;  ///< [W] v . C v
  double air_power(const double* v) const;           ///< [W] v . F_air, >= 0
  double wind_power(const State& state) const;       ///< [W] v . F_wind of the last commit
  /// M a = f for the unknowns with mass, all others 0: consistent initial accelerations.
  void accelerations(const double* u, const double* v, const double* force, double* a) const;
  /// The mass matrix at u, held unknowns included.
  void mass_matrix(const double* u, Matrix& M) const;

  /// Accepts u as the end of a step: of a static one, or of one in time, which ends at `time`.
  Accepted commit(const double* u);
  Accepted commit(const double* u, double time);
  /// The same, and of the wake behind a moving chain. [s]
  Accepted commit(const State& state, double time);

  /// Exchanges rotation vectors that have grown long against those of the same rotation by the other way round, and
  /// their rates. True where there was one: whoever keeps older states must start anew.
  bool shorten_rotations(double* u, double* v) const;

  /// Per section point, two per element, of the last commit. [J/m of unstressed length]
  const section::StepEnergy& step_energy() const { return energy_; }
  /// What the metal of the wires took in the same step.
  const section::MaterialMemory& material() const { return material_; }
  /// The committed memory of all section points.
  const section::History& history() const { return history_; }
  /// Strains per section point of the last commit.
  const section::Field& committed_strains() const { return committed_; }
  /// Resultants per section point of the last evaluation of forces.
  const section::Field& last_stresses() const { return stresses_; }
  /// [m] unstressed length that the section point stands for.
  double point_length(std::size_t point) const {
    return beam::gauss_weight * model_.elements[point / beam::gauss_points].length;
  }

  /// What a run has changed since `begin`: the history, the last commit, the counters.
  void archive(Archive& a);

  section::Effort effort() const { return effort_; }
  std::size_t residual_evaluations() const { return residual_evaluations_; }
  std::size_t jacobian_evaluations() const { return jacobian_evaluations_; }
  Stopwatch& stopwatch() const { return stopwatch_; }

 private:
  /// Strains at u, and what the sections answer; with the branches of the metal where the clock runs and `time` is
  /// given.
  void find_stresses(const double* u, std::optional<double> time, section::TangentField* tangents) const;
  void internal_force_at(const double* u, std::optional<double> time, double* f) const;
  void internal_force_at(const double* u, std::optional<double> time, double* f, Matrix& K) const;
  void add_springs(const double* u, double* f) const;
  void add_at_node(std::size_t node, const Eigen::Vector3d& force, double* f) const;
  void add_along(const model::Body& body, double factor, Matrix& K) const;

  const model::Model& model_;
  std::unique_ptr<Chain> chain_;
  std::vector<bool> held_, mass_;
  std::vector<std::size_t> moved_;   // unknown of each prescribed motion
  std::vector<model::Body> sprung_;  // those with a spring or a damper to the ground
  Vector drag_;                      // [N s/m] per unknown
  ProportionalDamping damping_;
  AirOnChain air_on_chain_;
  EccentricBodies eccentric_;
  air::AirForce air_;
  section::MaterialMemory material_;
  std::optional<double> clock_;  // [s] time of the last commit
  std::unique_ptr<WindOnChain> wind_;
  std::vector<std::unique_ptr<Attachment>> attached_;
  section::History history_;
  section::StepEnergy energy_;
  AlignedVector stored_at_begin_;  // [J/m] in each section point
  section::Field committed_;

  // Working storage of an evaluation.
  mutable section::Field strains_, stresses_;
  mutable section::TangentField tangents_;
  mutable Vector damping_force_, load_;
  mutable section::Effort effort_;
  mutable std::size_t residual_evaluations_ = 0;
  mutable std::size_t jacobian_evaluations_ = 0;
  mutable Stopwatch stopwatch_;
};

}  // namespace strandyn::system
