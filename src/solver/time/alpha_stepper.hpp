#pragma once
/// \file One step of the generalized-alpha method: prediction, Newton's method on u1, the state at the end.
///
/// Whole steps end at multiples of the step and at corners, which cut one in two. One that does not converge is gone in
/// parts of 1/2, 1/4, ... that grow again as soon as they fit.

#include "correction_test.hpp"
#include "stepper.hpp"

namespace strandyn::solver {

class AlphaStepper final : public Stepper {
 public:
  AlphaStepper(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
               GeneralizedAlpha method);

  bool step(double stop) override;
  StepTaken last() const override { return {.time = time_, .length = length_, .order = length_ > 0 ? 2 : 0}; }
  const system::Vector& u() const override { return now_.u; }
  const system::Vector& v() const override { return now_.v; }
  const system::Vector& a() const override { return now_.w; }
  /// Accelerations follow the forces.
  void restart() override;
  bool shorten_rotations() override;
  void archive(Archive& a) override;

  StepFailure failure() const override;
  std::size_t rejected_steps() const override { return rejected_steps_; }
  std::size_t newton_iterations() const override { return newton_iterations_; }

 private:
  /// Of a whole step, in powers of two.
  static constexpr int parts = 1024;
  /// The whole step under way.
  struct Whole {
    double start = 0;  // [s]
    int done = 0;      // of its parts
    int part = parts;  // the size of the next one
    void archive(Archive& a) { a(start, done, part); }
  };
  struct State {
    system::Vector u, v, w;  // w = v'
    void archive(Archive& a) { a(u, v, w); }
  };
  double next_multiple() const { return static_cast<double>(multiples_ + 1) * whole_step_; }
  double rounding() const { return 1e-6 * whole_step_; }
  void check_steps() const;
  bool advance(double end);
  double stretched(double length) const;
  void adapt_to(double h);
  void predict(double end);
  void held_accelerations(double t, system::Vector& w);
  bool solve(double end);
  bool correct(double end, bool fresh);

  system::At at(double t) const { return {.time = t, .drives = drives_}; }

  system::System& system_;
  const std::vector<model::Drive> drives_;
  const GeneralizedAlpha method_;
  const double alpha_m_, alpha_f_, gamma_, beta_;
  const double whole_step_;  // [s]
  const double fitted_;      // [rad/s] the frequency that steps keep; 0: none
  const int max_iterations_;
  CorrectionTest test_;
  double time_ = 0;
  double length_ = 0;          // [s] of the last step
  std::size_t multiples_ = 0;  // of the whole step that lie behind
  Whole whole_;
  double tried_ = 0;  // [s] the step that failed last
  std::size_t rejected_steps_ = 0;
  double h_;  // [s] the step that `a_` goes with, stretched
  State now_, next_;
  system::Vector a_, next_a_;
  bool starting_ = true;  // no step lies behind the state: a_ is not known yet
  system::Vector rate_;   // (u1 - u0)/h of the step before: where the next one is looked for
  double dv_ = 0;         // [1/s] dv1/du1 of the step at hand
  double dw_ = 0;         // [1/s^2] dw1/du1
  int patience_ = 2;      // corrections that old factors may serve
  double factored_ = 0;   // [1/s^2] the same in the factors at hand; 0: there are none
  system::Matrix K_;
  math::ChainFactors factors_;
  system::Vector correction_;
  system::Vector earlier_rates_, later_rates_;  // of held unknowns
  std::size_t newton_iterations_ = 0;
};

}  // namespace strandyn::solver
