#pragma once
/// \file The balance of all harmonics of a driven chain, and Newton's corrections of it.

#include <array>
#include <optional>
#include <vector>

#include "periodic_fourier.hpp"
#include "periodic_loop.hpp"
#include "periodic_matrix.hpp"
#include "strandyn/air/still_air.hpp"
#include "strandyn/solver/periodic/periodic.hpp"

namespace strandyn::solver {

/// Where a solution stands, or how it changes.
struct PeriodicPoint {
  Eigen::MatrixXd x;  // unknowns by coefficients, from rest
  double omega = 0;   // [rad/s]
  double drive = 0;   // [N] or [m]
};

/// One of the two equations that close the balance: gap + d(gap) = 0.
struct Closing {
  struct Term {
    std::size_t unknown = 0;
    Eigen::Index coefficient = 0;
    double factor = 0;
  };
  double gap = 0;
  std::vector<Term> terms = {};
  double by_omega = 0, by_drive = 0;
};
using Closings = std::array<Closing, 2>;

struct BalanceEvaluation {
  std::vector<section::Field> strains;  // per sample
  SectionLoops loops;
  std::vector<section::Field> with_metal;  // per sample: loops.stresses and the metal on top; empty without metal
  Eigen::MatrixXd force;     // [N], [N m] what the chain asks for, harmonics: at a moved support its reaction
  Eigen::MatrixXd residual;  // the same less the drive; of held unknowns: where they are less where they should be
};

/// What the sections answer to a change of their curvatures.
struct SectionModel {
  section::TangentField mean;         // to all harmonics alike: the secant of the fundamental where they slip
  std::vector<std::size_t> slipping;  // points that were asked for more
  /// What comes on top, of each of them: coefficients of the moments by coefficients of the curvatures, axis after
  /// axis.
  std::vector<Eigen::MatrixXd> extra;
  section::Effort effort = {};
  std::vector<double> places = {};  // [-] of all points, in parts of the chain
  Eigen::Index coefficients = 0;
};

/// One component of all section points, points by samples.
Eigen::MatrixXd samples_of(const std::vector<section::Field>& fields, section::Component c);

class HarmonicBalance {
 public:
  /// Throws std::invalid_argument where setup or options are not possible.
  HarmonicBalance(const system::System& system, const system::Vector& rest, const PeriodicSetup& setup,
                  const PeriodicOptions& options);

  std::size_t drive() const { return drive_; }       ///< unknown
  std::size_t control() const { return control_; }   ///< unknown
  double total_mass() const { return total_mass_; }  ///< [kg]
  const Fourier& fourier() const { return fourier_; }

  BalanceEvaluation evaluate(const PeriodicPoint& point) const;
  /// The secants, at no cost.
  SectionModel secant_model(const BalanceEvaluation& at) const;
  /// [-] largest loss of stiffness of a section against rest.
  double softening(const SectionModel& model) const;
  /// The derivatives too.
  SectionModel probed_model(const BalanceEvaluation& at) const;
  /// A model of this chain on another mesh or of other harmonics, as its nearest points have it. Empty where it knows
  /// fewer harmonics.
  std::optional<SectionModel> carried_model(const SectionModel& other) const;
  /// The change that closes residual and closings, both as far as they are linear. False where there is none.
  bool correct(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
               const Closings& closings, PeriodicPoint& change) const;
  /// The change along the curve: the residual stays zero, the first closing changes by one, the second not.
  bool direction(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
                 const Closings& closings, PeriodicPoint& change) const;
  /// Losses and work of a converged state.
  void account(const PeriodicPoint& point, const BalanceEvaluation& at, PeriodicSolution& solution) const;

 private:
  struct Swing {
    Eigen::MatrixXd u, v, a;  // unknowns by samples
  };
  Swing swing(const PeriodicPoint& point) const;
  /// Harmonics of M u'' + g + C u' + F_air.
  Eigen::MatrixXd inertia(const PeriodicPoint& point) const;
  /// The air's force on a swing: linear at harmonic k; what is not linear, at the fundamental.
  air::AirForce linear_air(const PeriodicPoint& point, int k) const;
  air::AirForce other_air(const PeriodicPoint& point) const;
  void add_material(const PeriodicPoint& point, BalanceEvaluation& at) const;
  void account_for_air(const PeriodicPoint& point, PeriodicSolution& solution) const;
  void account_for_material(const PeriodicPoint& point, const BalanceEvaluation& at, PeriodicSolution& solution) const;
  bool solve(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
             const Closings& closings, Eigen::MatrixXd equations, Eigen::MatrixXd closing_values,
             PeriodicPoint& change) const;
  void assemble(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model, HarmonicMatrix& T,
                std::vector<Eigen::VectorXd>& columns, std::vector<Eigen::VectorXd>& rows) const;
  /// Of the sections at rest with these tangents, without stresses and without the springs of bodies.
  void section_stiffness(const section::TangentField& tangents, system::Matrix& K) const;
  void add_air_and_metal(const PeriodicPoint& point, HarmonicMatrix& T) const;
  void add_slip(const SectionModel& model, HarmonicMatrix& T) const;
  Eigen::MatrixXd fundamental_curvature(const BalanceEvaluation& at, std::size_t p) const;    // cosine, sine by axes
  Eigen::MatrixXd moments(const std::vector<section::Field>& stresses, std::size_t p) const;  // coefficients by axes
  Eigen::MatrixXd harmonics_of(const std::vector<section::Field>& fields, section::Component c, std::size_t p) const;

  const system::System& system_;
  const system::Vector& rest_;
  PeriodicSetup setup_;
  PeriodicOptions options_;
  Fourier fourier_;
  std::vector<section::Component> axes_;  // of bending
  std::size_t drive_ = 0, control_ = 0;
  double total_mass_ = 0;
  system::Matrix M_, C_;             // at rest
  std::optional<system::Matrix> A_;  // [m] of still air: forces per linear factor
  section::TangentField tangents_;   // at rest
  std::vector<double> places_;       // [-] of the section points, in parts of the chain
  section::Field unstressed_;
  std::optional<system::Matrix> springs_;  // of bodies
};

}  // namespace strandyn::solver
