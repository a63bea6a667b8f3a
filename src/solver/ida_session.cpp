#include "ida_session.hpp"

#include <fmt/format.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {
namespace {

/// IDA's error test sees this: small enough to pass always, the same at every order, so that order 2 is kept.
realtype constant_error(N_Vector, N_Vector, N_Vector) {
  return 1e-4;
}

void check(int flag, const char* call) {
  if (flag < 0) throw ComputationError(fmt::format("{} failed with code {}", call, flag));
}

SUNContext make_context() {
  SUNContext context = nullptr;
  check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  return context;
}

N_Vector make_vector(std::size_t n, SUNContext context) {
  N_Vector v = N_VNew_Serial(static_cast<sunindextype>(2 * n), context);
  v->ops->nvwrmsnormmask = constant_error;  // clones inherit it
  N_VConst(0, v);
  return v;
}

}  // namespace

IdaSession::IdaSession(system::System& system, const InitialMotion& initial, const IdaOptions& options)
    : problem_(system),
      options_(options),
      context_(make_context()),
      y_(make_vector(system.unknowns(), context_.get())),
      yp_(make_vector(system.unknowns(), context_.get())),
      id_(make_vector(system.unknowns(), context_.get())),
      ida_(IDACreate(context_.get())) {
  const std::size_t n = system.unknowns();
  double* y = N_VGetArrayPointer(y_.get());
  double* yp = N_VGetArrayPointer(yp_.get());
  std::copy(initial.u.begin(), initial.u.end(), y);
  system::Vector force(initial.u.size());
  system::Vector internal(initial.u.size());
  system.external_force(0, force.data());
  system.internal_force(y, internal.data());
  force -= internal;
  for (std::size_t i = 0; i < n; ++i) {
    const double rate = initial.v(static_cast<Eigen::Index>(i));
    if (system.has_mass(i)) y[n + i] = rate;
    yp[i] = system.is_held(i) ? 0.0 : rate;
    N_VGetArrayPointer(id_.get())[i] = N_VGetArrayPointer(id_.get())[n + i] = system.has_mass(i) ? 1 : 0;
  }
  system.accelerations(y, y + n, force.data(), yp + n);

  void* ida = ida_.get();
  check(IDASetErrFile(ida, nullptr), "IDASetErrFile");  // `failure` says it better
  check(IDAInit(ida, residual, 0, y_.get(), yp_.get()), "IDAInit");
  check(IDASetUserData(ida, this), "IDASetUserData");
  check(IDASStolerances(ida, 1e-4, 1e-6), "IDASStolerances");  // unused by the tests below, but IDA wants them
  check(IDASetMaxOrd(ida, 2), "IDASetMaxOrd");
  check(IDASetId(ida, id_.get()), "IDASetId");
  check(IDASetSuppressAlg(ida, SUNTRUE), "IDASetSuppressAlg");  // the error test then calls the masked norm
  check(IDASetMaxStep(ida, options.step), "IDASetMaxStep");
  // IDA doubles from its second step on: 1 + 1 + 2 + 4 + ... + 128 = 256. So nine steps make one whole step, and those
  // that follow meet the cycle's ends.
  check(IDASetInitStep(ida, options.step / 256), "IDASetInitStep");
  check(IDASetMaxConvFails(ida, 20), "IDASetMaxConvFails");

  make_linear_solver();
  check(IDASetLinearSolver(ida, linear_.get(), matrix_.get()), "IDASetLinearSolver");
  check(IDASetJacFn(ida, refresh), "IDASetJacFn");
  check(IDASetLinearSolutionScaling(ida, SUNFALSE), "IDASetLinearSolutionScaling");

  nonlinear_.reset(SUNNonlinSol_Newton(y_.get(), context_.get()));
  check(IDASetNonlinearSolver(ida, nonlinear_.get()), "IDASetNonlinearSolver");
  check(IDASetMaxNonlinIters(ida, options.max_newton_iterations), "IDASetMaxNonlinIters");
  check(SUNNonlinSolSetConvTestFn(nonlinear_.get(), has_converged, this), "SUNNonlinSolSetConvTestFn");
}

void IdaSession::make_linear_solver() {
  matrix_.reset(SUNMatNewEmpty(context_.get()));
  matrix_->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix_->ops->zero = [](SUNMatrix) { return 0; };
  matrix_->ops->destroy = [](SUNMatrix m) { SUNMatFreeEmpty(m); };

  linear_.reset(SUNLinSolNewEmpty(context_.get()));
  linear_->content = this;
  linear_->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  linear_->ops->initialize = [](SUNLinearSolver) { return 0; };
  linear_->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };  // `refresh` has factored already
  linear_->ops->solve = solve;
  linear_->ops->free = [](SUNLinearSolver s) {
    s->content = nullptr;
    SUNLinSolFreeEmpty(s);
    return 0;
  };
}

/// SUNDIALS is C: an exception must not cross it. It is kept and thrown again when IDA has returned.
template <class F>
int IdaSession::guarded(F&& work) {
  try {
    work();
    return 0;
  } catch (...) {
    exception_ = std::current_exception();
    return -1;
  }
}

int IdaSession::residual(realtype t, N_Vector y, N_Vector yp, N_Vector f, void* self) {
  auto& session = *static_cast<IdaSession*>(self);
  return session.guarded(
      [&] { session.problem_.residual(t, N_VGetArrayPointer(y), N_VGetArrayPointer(yp), N_VGetArrayPointer(f)); });
}

int IdaSession::refresh(realtype, realtype cj, N_Vector, N_Vector, N_Vector, SUNMatrix, void* self, N_Vector, N_Vector,
                        N_Vector) {
  auto& session = *static_cast<IdaSession*>(self);
  return session.guarded([&] { session.problem_.refresh(cj); });
}

int IdaSession::solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, realtype) {
  auto& session = *static_cast<IdaSession*>(solver->content);
  return session.guarded([&] {
    int iteration = 0;
    SUNNonlinSolGetCurIter(session.nonlinear_.get(), &iteration);
    realtype cj = 0;
    IDAGetCurrentCj(session.ida_.get(), &cj);
    // Old factors serve as long as two corrections suffice; a step in which wires begin to slip wants its own tangent.
    const bool stale = std::abs(cj / session.problem_.factored_cj() - 1) > 0.01;
    if (iteration >= 2 || stale) session.problem_.refresh(cj);
    session.problem_.solve(N_VGetArrayPointer(b), N_VGetArrayPointer(x));
  });
}

int IdaSession::has_converged(SUNNonlinearSolver solver, N_Vector, N_Vector correction, realtype, N_Vector,
                              void* self) {
  auto& session = *static_cast<IdaSession*>(self);
  const double* du = N_VGetArrayPointer(correction);
  const std::size_t n = session.problem_.unknowns();
  const double norm = std::sqrt(std::inner_product(du, du + n, du, 0.0));
  int iteration = 0;
  SUNNonlinSolGetCurIter(solver, &iteration);
  const double before = session.previous_norm_;
  session.previous_norm_ = norm;
  const double tolerance = session.options_.newton_tolerance;
  if (!std::isfinite(norm)) return SUN_NLS_CONV_RECVR;
  if (norm <= 0.1 * tolerance) return SUN_NLS_SUCCESS;
  if (iteration == 0) return SUN_NLS_CONTINUE;  // one correction says nothing about the rate
  if (norm <= tolerance) return SUN_NLS_SUCCESS;
  session.last_correction_ = Eigen::Map<const system::Vector>(du, static_cast<Eigen::Index>(n));
  const double rate = norm / before;
  if (rate < 0.5 && norm * rate / (1 - rate) <= 0.1 * tolerance) return SUN_NLS_SUCCESS;
  return iteration >= 3 && rate > 2 ? SUN_NLS_CONV_RECVR : SUN_NLS_CONTINUE;
}

bool IdaSession::step() {
  realtype reached = time_;
  const int flag = IDASolve(ida_.get(), options_.end_time, &reached, y_.get(), yp_.get(), IDA_ONE_STEP);
  if (exception_) std::rethrow_exception(exception_);
  time_ = reached;
  return flag >= 0;
}

double IdaSession::last_step() const {
  realtype h = 0;
  IDAGetLastStep(ida_.get(), &h);
  return h;
}

int IdaSession::last_order() const {
  int order = 0;
  IDAGetLastOrder(ida_.get(), &order);
  return order;
}

std::size_t IdaSession::rejected_steps() const {
  long failures = 0;
  long nonlinear = 0;
  IDAGetNumErrTestFails(ida_.get(), &failures);
  IDAGetNumNonlinSolvConvFails(ida_.get(), &nonlinear);
  return static_cast<std::size_t>(failures + nonlinear);
}

std::size_t IdaSession::newton_iterations() const {
  long iterations = 0;
  IDAGetNumNonlinSolvIters(ida_.get(), &iterations);
  return static_cast<std::size_t>(iterations);
}

std::string IdaSession::failure() const {
  realtype h = 0;
  IDAGetCurrentStep(ida_.get(), &h);
  std::string text = fmt::format(
      "the step at t = {:.6g} s did not converge, even cut to {:.3g} s (order {}, {} steps cut "
      "in all)",
      time_, h, last_order(), rejected_steps());
  std::vector<std::size_t> order(static_cast<std::size_t>(last_correction_.size()));
  std::iota(order.begin(), order.end(), 0);
  const std::size_t shown = std::min<std::size_t>(10, order.size());
  const auto size = [&](std::size_t i) { return std::abs(last_correction_(static_cast<Eigen::Index>(i))); };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("{} {} ({:.2g})", i == 0 ? "; largest last corrections:" : ",", model::unknown_name(order[i]),
                        size(order[i]));
  }
  return text + "; try more [integrator] steps_per_cycle";
}

}  // namespace strandyn::solver
