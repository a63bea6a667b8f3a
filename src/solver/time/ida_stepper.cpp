#include "ida_stepper.hpp"

#include <fmt/format.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "ida_memory.hpp"
#include "strandyn/core/error.hpp"
#include "sundials_versions.hpp"
#include "vector_ops.hpp"

namespace strandyn::solver {
namespace {

/// IDA's error test sees this: small enough to pass always, the same at every order, so that order 2 is kept.
sunrealtype constant_error(N_Vector, N_Vector, N_Vector) {
  return 1e-4;
}

void check(int flag, const char* call) {
  if (flag < 0) throw ComputationError(fmt::format("{} failed with code {}", call, flag));
}

SUNContext make_context() {
  SUNContext context = nullptr;
  check(sundials::make_context(context), "SUNContext_Create");
  return context;
}

N_Vector make_vector(std::size_t n, SUNContext context, bool hold_order) {
  N_Vector v = N_VNew_Serial(static_cast<sunindextype>(2 * n), context);
  use_wide_operations(v);
  if (hold_order) v->ops->nvwrmsnormmask = constant_error;  // clones inherit it
  N_VConst(0, v);
  return v;
}

}  // namespace

IdaStepper::IdaStepper(system::System& system, const InitialMotion& initial, const IntegratorOptions& options)
    : system_(system),
      problem_(system, options.drives),
      options_(options),
      context_(make_context()),
      y_(make_vector(system.unknowns(), context_.get(), options.relative_error == 0)),
      yp_(make_vector(system.unknowns(), context_.get(), options.relative_error == 0)),
      id_(make_vector(system.unknowns(), context_.get(), options.relative_error == 0)),
      ida_(IDACreate(context_.get())),
      u_(initial.u),
      v_(initial.v),
      a_(system.make_vector()),
      start_(initial.u),
      test_(options.newton_tolerance, system.unknowns()) {
  const std::size_t n = system.unknowns();
  for (std::size_t i = 0; i < n; ++i) {
    N_VGetArrayPointer(id_.get())[i] = N_VGetArrayPointer(id_.get())[n + i] = system.has_mass(i) ? 1 : 0;
  }
  set_state();
  read_state();
  // A micrometre, a microradian, and as much per step: what counts before the motion has begun.
  largest_ = {1e-6, 1e-6, 1e-6 / options.step, 1e-6 / options.step};

  void* ida = ida_.get();
  check(sundials::silence(context_.get(), ida), "the call that silences IDA");  // `failure` says it better
  check(IDAInit(ida, residual, 0, y_.get(), yp_.get()), "IDAInit");
  check(IDASetUserData(ida, this), "IDASetUserData");
  check(IDAWFtolerances(ida, weights), "IDAWFtolerances");
  check(IDASetMaxOrd(ida, 2), "IDASetMaxOrd");
  check(IDASetId(ida, id_.get()), "IDASetId");
  if (options.relative_error == 0) {
    check(IDASetSuppressAlg(ida, SUNTRUE), "IDASetSuppressAlg");  // the error test then calls the masked norm
  }
  check(IDASetMaxStep(ida, options.step), "IDASetMaxStep");
  // IDA doubles from its second step on: 1 + 1 + 2 + 4 + ... + 128 = 256. So nine steps make one whole step, and those
  // that follow meet the cycle's ends.
  check(IDASetInitStep(ida, options.step / 256), "IDASetInitStep");
  check(IDASetMaxConvFails(ida, 20), "IDASetMaxConvFails");
  // A step that has to be cut below this does not move time.
  check(IDASetMinStep(ida, options.step * std::exp2(-40)), "IDASetMinStep");

  make_linear_solver();
  check(IDASetLinearSolver(ida, linear_.get(), matrix_.get()), "IDASetLinearSolver");
  check(IDASetJacFn(ida, refresh), "IDASetJacFn");
  check(IDASetLinearSolutionScaling(ida, SUNFALSE), "IDASetLinearSolutionScaling");

  nonlinear_.reset(SUNNonlinSol_Newton(y_.get(), context_.get()));
  check(IDASetNonlinearSolver(ida, nonlinear_.get()), "IDASetNonlinearSolver");
  check(IDASetMaxNonlinIters(ida, options.max_newton_iterations), "IDASetMaxNonlinIters");
  check(SUNNonlinSolSetConvTestFn(nonlinear_.get(), has_converged, this), "SUNNonlinSolSetConvTestFn");
}

/// y and y' of u and v: velocities of unknowns with mass, accelerations that go with the forces.
void IdaStepper::set_state() {
  const std::size_t n = system_.unknowns();
  const system::At at{.time = time_, .drives = options_.drives};
  double* y = N_VGetArrayPointer(y_.get());
  double* yp = N_VGetArrayPointer(yp_.get());
  std::copy(u_.begin(), u_.end(), y);
  for (std::size_t i = 0; i < n; ++i) y[n + i] = system_.has_mass(i) ? v_(static_cast<Eigen::Index>(i)) : 0.0;
  if (system_.has_moving_supports()) system_.held_rates(at, y + n);
  system::Vector force = system_.make_vector();
  system_.residual({.u = y}, at, force.data());
  force = -force;
  for (std::size_t i = 0; i < n; ++i) {
    // Rates of unknowns without mass only help the first predictor.
    yp[i] = system_.is_held(i) ? y[n + i] : v_(static_cast<Eigen::Index>(i));
  }
  system_.accelerations(y, y + n, force.data(), yp + n);
}

/// u, v and a of the y and y' at hand.
void IdaStepper::read_state() {
  const double* y = N_VGetArrayPointer(y_.get());
  u_ = Eigen::Map<const system::Vector>(y, u_.size());
  v_ = Eigen::Map<const system::Vector>(y + u_.size(), u_.size());
  a_ = Eigen::Map<const system::Vector>(N_VGetArrayPointer(yp_.get()) + u_.size(), u_.size());
}

bool IdaStepper::shorten_rotations() {
  return system_.shorten_rotations(u_.data(), v_.data());
}

void IdaStepper::restart() {
  rejected_before_ = rejected_steps();  // IDA counts from here
  iterations_before_ = newton_iterations();
  set_state();
  begin_anew();
}

/// From the y and y' at hand.
void IdaStepper::begin_anew() {
  check(IDAReInit(ida_.get(), time_, y_.get(), yp_.get()), "IDAReInit");
  check(IDASetInitStep(ida_.get(), options_.step / 256), "IDASetInitStep");
}

void IdaStepper::archive(Archive& a) {
  const auto vector = [&](N_Vector v) {
    for (sunindextype i = 0; i < N_VGetLength(v); ++i) a(N_VGetArrayPointer(v)[i]);
  };
  bool stepped = has_stepped();
  a(stepped);
  // IDA sets itself up in its first step; what comes of it is replaced.
  if (a.reads() && stepped && !advance(options_.end_time)) throw ComputationError("IDA could not set itself up again");
  a(time_, length_, largest_, patience_, rejected_before_, iterations_before_, problem_);
  vector(y_.get());
  vector(yp_.get());
  if (a.reads()) read_state();
  if (stepped) {
    archive_ida(a, ida_.get());
  } else if (a.reads()) {
    begin_anew();
  }
}

void IdaStepper::make_linear_solver() {
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

/// Weights of the error test: each kind of unknown against the largest that it has been. Held order asks for none.
int IdaStepper::weights(N_Vector y, N_Vector weight, void* self) {
  auto& stepper = *static_cast<IdaStepper*>(self);
  const double error = stepper.options_.relative_error;
  N_VConst(1, weight);
  if (error == 0) return 0;
  const model::Model& model = stepper.system_.model();
  const std::size_t n = stepper.problem_.unknowns();
  const double* state = N_VGetArrayPointer(y);
  double* w = N_VGetArrayPointer(weight);
  const auto kind = [&](std::size_t i) {
    return (i < n ? 0U : 2U) + (model::is_rotation(model.kind(i % n)) ? 1U : 0U);
  };
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double start = i < n ? stepper.start_(static_cast<Eigen::Index>(i)) : 0;
    stepper.largest_[kind(i)] = std::max(stepper.largest_[kind(i)], std::abs(state[i] - start));
  }
  for (std::size_t i = 0; i < 2 * n; ++i) w[i] = 1 / (error * stepper.largest_[kind(i)]);
  return 0;
}

/// SUNDIALS is C: an exception must not cross it. It is kept and thrown again when IDA has returned. Work that says
/// false is what a shorter step may do better.
template <class F>
int IdaStepper::guarded(F&& work) {
  try {
    if constexpr (std::is_same_v<decltype(work()), bool>) return work() ? 0 : 1;
    work();
    return 0;
  } catch (...) {
    exception_ = std::current_exception();
    return -1;
  }
}

int IdaStepper::residual(sunrealtype t, N_Vector y, N_Vector yp, N_Vector f, void* self) {
  auto& stepper = *static_cast<IdaStepper*>(self);
  const bool with_tangent = std::exchange(stepper.tangent_follows_, false);
  return stepper.guarded([&] {
    stepper.problem_.residual(t, N_VGetArrayPointer(y), N_VGetArrayPointer(yp), N_VGetArrayPointer(f), with_tangent);
  });
}

int IdaStepper::refresh(sunrealtype, sunrealtype cj, N_Vector, N_Vector, N_Vector, SUNMatrix, void* self, N_Vector,
                        N_Vector, N_Vector) {
  auto& stepper = *static_cast<IdaStepper*>(self);
  return stepper.guarded([&] { return stepper.problem_.refresh(cj); });
}

int IdaStepper::solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, sunrealtype) {
  auto& stepper = *static_cast<IdaStepper*>(solver->content);
  return stepper.guarded([&] {
    int iteration = 0;
    SUNNonlinSolGetCurIter(stepper.nonlinear_.get(), &iteration);
    sunrealtype cj = 0;
    IDAGetCurrentCj(stepper.ida_.get(), &cj);
    const bool stale = std::abs(cj / stepper.problem_.factored_cj() - 1) > 0.01;
    if ((iteration >= stepper.patience_ || stale) && !stepper.problem_.refresh(cj)) return false;
    stepper.problem_.solve(N_VGetArrayPointer(b), N_VGetArrayPointer(x));
    return true;
  });
}

int IdaStepper::has_converged(SUNNonlinearSolver solver, N_Vector, N_Vector correction, sunrealtype, N_Vector,
                              void* self) {
  auto& stepper = *static_cast<IdaStepper*>(self);
  int iteration = 0;
  SUNNonlinSolGetCurIter(solver, &iteration);
  switch (stepper.test_.judge(iteration, N_VGetArrayPointer(correction))) {
    case Verdict::arrived:
      stepper.patience_ = old_factors_serve(iteration + 1);
      return sundials::converged;
    case Verdict::on_the_way:
      stepper.tangent_follows_ = iteration + 1 >= stepper.patience_;
      return SUN_NLS_CONTINUE;
    default:
      return SUN_NLS_CONV_RECVR;
  }
}

/// y and y' of one step further.
bool IdaStepper::advance(double stop) {
  sunrealtype reached = time_;
  check(IDASetStopTime(ida_.get(), stop), "IDASetStopTime");
  const int flag = IDASolve(ida_.get(), options_.end_time, &reached, y_.get(), yp_.get(), IDA_ONE_STEP);
  if (exception_) std::rethrow_exception(exception_);
  time_ = reached;
  return flag >= 0;
}

bool IdaStepper::step(double stop) {
  if (!advance(stop)) return false;
  IDAGetLastStep(ida_.get(), &length_);
  read_state();
  return true;
}

/// Since it began, or began anew.
bool IdaStepper::has_stepped() const {
  long steps = 0;
  IDAGetNumSteps(ida_.get(), &steps);
  return steps > 0;
}

StepTaken IdaStepper::last() const {
  StepTaken taken{.time = time_, .length = length_, .order = 0};
  if (length_ > 0) IDAGetLastOrder(ida_.get(), &taken.order);
  return taken;
}

std::size_t IdaStepper::rejected_steps() const {
  long failures = 0;
  long nonlinear = 0;
  IDAGetNumErrTestFails(ida_.get(), &failures);
  IDAGetNumNonlinSolvConvFails(ida_.get(), &nonlinear);
  return rejected_before_ + static_cast<std::size_t>(failures + nonlinear);
}

std::size_t IdaStepper::newton_iterations() const {
  long iterations = 0;
  IDAGetNumNonlinSolvIters(ida_.get(), &iterations);
  return iterations_before_ + static_cast<std::size_t>(iterations);
}

StepFailure IdaStepper::failure() const {
  sunrealtype h = 0;
  IDAGetCurrentStep(ida_.get(), &h);
  int order = 0;
  IDAGetLastOrder(ida_.get(), &order);
  return {.length = h, .order = order, .corrections = test_.worst_unknowns(system_.model())};
}

std::unique_ptr<Stepper> make_stepper(const Ida&, system::System& system, const InitialMotion& initial,
                                      const IntegratorOptions& options) {
  return std::make_unique<IdaStepper>(system, initial, options);
}

}  // namespace strandyn::solver
