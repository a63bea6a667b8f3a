#pragma once
/// \file The one layer over SUNDIALS: owns every handle, catches exceptions at the C boundary, reads the counters.

#include <exception>
#include <memory>
#include <string>

#include "chain_problem.hpp"
#include "correction_test.hpp"
#include "stepper.hpp"
#include "sundials_versions.hpp"

namespace strandyn::solver {

/// Deleters for SUNDIALS' handles.
struct FreeContext {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
};
struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeMatrix {
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
};
struct FreeLinearSolver {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct FreeNonlinearSolver {
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
};
struct FreeIda {
  void operator()(void* ida) const { IDAFree(&ida); }
};

template <class Handle, class Deleter>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Deleter>;

/// An IDA integrator over a ChainProblem, at order 2 with steps up to a bound.
class IdaStepper final : public Stepper {
 public:
  IdaStepper(system::System& system, const InitialMotion& initial, const IntegratorOptions& options);
  IdaStepper(const IdaStepper&) = delete;
  IdaStepper& operator=(const IdaStepper&) = delete;

  bool step(double stop) override;
  StepTaken last() const override;
  const system::Vector& u() const override { return u_; }
  const system::Vector& v() const override { return v_; }
  const system::Vector& a() const override { return a_; }
  /// A multistep formula starts anew at a corner: its older steps lie on another line.
  void restart() override;
  bool shorten_rotations() override;
  void archive(Archive& a) override;

  StepFailure failure() const override;
  std::size_t rejected_steps() const override;
  std::size_t newton_iterations() const override;

 private:
  // What SUNDIALS calls. `self` is this object.
  static int residual(sunrealtype t, N_Vector y, N_Vector yp, N_Vector f, void* self);
  static int refresh(sunrealtype t, sunrealtype cj, N_Vector y, N_Vector yp, N_Vector r, SUNMatrix J, void* self,
                     N_Vector, N_Vector, N_Vector);
  static int weights(N_Vector y, N_Vector weight, void* self);
  static int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, sunrealtype);
  static int has_converged(SUNNonlinearSolver solver, N_Vector y, N_Vector correction, sunrealtype, N_Vector,
                           void* self);
  void make_linear_solver();
  bool has_stepped() const;
  void begin_anew();
  void set_state();
  void read_state();
  bool advance(double stop);
  template <class F>
  int guarded(F&& work);

  system::System& system_;
  ChainProblem problem_;
  IntegratorOptions options_;
  Owned<SUNContext, FreeContext> context_;
  Owned<N_Vector, FreeVector> y_, yp_, id_;
  Owned<SUNMatrix, FreeMatrix> matrix_;
  Owned<SUNLinearSolver, FreeLinearSolver> linear_;
  Owned<SUNNonlinearSolver, FreeNonlinearSolver> nonlinear_;
  std::unique_ptr<void, FreeIda> ida_;
  double time_ = 0;
  double length_ = 0;  // [s] of the last step; 0 before the first
  system::Vector u_, v_, a_;
  system::Vector start_;             // initial u: what error control measures motion from
  std::array<double, 4> largest_{};  // motion so far: translation, rotation, and their rates
  CorrectionTest test_;
  std::size_t rejected_before_ = 0, iterations_before_ = 0;  // until the last restart
  int patience_ = 2;                                         // corrections that old factors may serve
  bool tangent_follows_ = false;  // on the next residual: the correction after it takes fresh factors
  std::exception_ptr exception_;
};

}  // namespace strandyn::solver
