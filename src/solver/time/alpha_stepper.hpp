#pragma once
/// \file One step of the generalized-alpha method: prediction, Newton's method on u1, the state at the end.

#include "correction_test.hpp"
#include "strandyn/solver/time/generalized_alpha.hpp"

namespace strandyn::solver {

class AlphaStepper {
 public:
  AlphaStepper(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
               GeneralizedAlpha method);

  /// Steps to `end`. False where Newton did not converge: the state is then what it was.
  bool step(double end);
  /// Begins anew from the state at hand, where loads or motions have a corner: accelerations follow the forces.
  void restart();
  /// Exchanges long rotation vectors, and begins anew where there was one.
  void shorten_rotations();
  /// Between two steps.
  void archive(Archive& a);

  double time() const { return time_; }
  const system::Vector& u() const { return now_.u; }
  const system::Vector& v() const { return now_.v; }
  const system::Vector& w() const { return now_.w; }
  std::size_t newton_iterations() const { return newton_iterations_; }
  std::string worst_unknowns() const { return test_.worst_unknowns(system_.model()); }

 private:
  struct State {
    system::Vector u, v, w;  // w = v'
    void archive(Archive& a) { a(u, v, w); }
  };
  void adapt_to(double h);
  void predict(double end);
  void held_accelerations(double t, system::Vector& w);
  bool solve(double end);
  bool correct(double end, bool fresh);

  system::System& system_;
  const double alpha_m_, alpha_f_, gamma_, beta_;
  const double whole_step_;  // [s]
  const int max_iterations_;
  CorrectionTest test_;
  double time_ = 0;
  double h_;  // [s] the step that `a_` goes with
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
  system::Vector external_, correction_;
  system::Vector earlier_rates_, later_rates_;  // of held unknowns
  std::size_t newton_iterations_ = 0;
};

}  // namespace strandyn::solver
