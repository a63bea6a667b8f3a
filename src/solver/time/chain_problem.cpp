#include "chain_problem.hpp"

#include <algorithm>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {

ChainProblem::ChainProblem(system::System& system)
    : system_(system),
      external_(static_cast<Eigen::Index>(system.unknowns())),
      internal_(external_.size()),
      u_(external_.size()),
      v_(external_.size()),
      a_(external_.size()),
      K_(system.make_matrix()),
      G_(system.make_matrix()),
      held_(system.make_vector()),
      held_rates_(held_),
      right_side_(external_.size()),
      product_(external_.size()) {}

void ChainProblem::residual(double t, const double* y, const double* yp, double* f, bool with_tangent) {
  const std::size_t n = unknowns();
  std::copy(y, y + n, u_.data());
  std::copy(y + n, y + 2 * n, v_.data());
  std::copy(yp + n, yp + 2 * n, a_.data());
  time_ = t;
  system_.external_force({.time = t}, y, external_.data());
  if (system_.has_moving_supports()) {
    system_.held_values({.time = t}, held_.data());
    system_.held_rates(t, held_rates_.data());
  }
  double* balance = f + n;
  if (with_tangent) {
    system_.internal_force(y, balance, K_);
  } else {
    system_.internal_force(y, balance);
  }
  tangent_at_hand_ = with_tangent;
  system_.add_inertia_and_drag({.u = y, .v = y + n, .a = yp + n}, balance);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    f[i] = system_.has_mass(i) ? yp[i] - y[n + i] : y[n + i] - held_rates_(at);
    balance[i] = system_.is_held(i) ? y[i] - held_(at) : balance[i] - external_(at);
  }
}

void ChainProblem::refresh(double cj) {
  const system::Motion motion{.u = u_.data(), .v = v_.data(), .a = a_.data()};
  if (!tangent_at_hand_) system_.internal_force(u_.data(), internal_.data(), K_);
  tangent_at_hand_ = false;  // what follows makes another matrix of it
  system_.subtract_external_tangent({.time = time_}, u_.data(), K_);
  system_.add_inertia_and_drag(motion, {.acceleration = cj * cj, .velocity = cj, .position = 1}, K_);
  G_.set_zero();
  system_.add_inertia_and_drag(motion, {.acceleration = cj, .velocity = 1, .position = 0}, G_);
  const Stopwatch::Lap lap(system_.stopwatch(), Part::factorization);
  system_.hold(K_);
  if (!factors_.factorize(K_)) throw ComputationError("the matrix of the implicit step is singular");
  cj_ = cj;
}

void ChainProblem::solve(const double* b, double* x) {
  const Stopwatch::Lap lap(system_.stopwatch(), Part::solve);
  const std::size_t n = unknowns();
  // The columns of K + cj G take dv = cj du for granted; held unknowns have the du and dv of their own equations.
  for (std::size_t i = 0; i < n; ++i) {
    const double held = system_.is_held(i) ? cj_ * b[n + i] - b[i] : 0.0;
    right_side_(static_cast<Eigen::Index>(i)) = system_.has_mass(i) ? b[i] : held;
  }
  G_.multiply(right_side_.data(), product_.data());
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = b[n + i] + (system_.is_held(i) ? 0.0 : product_(static_cast<Eigen::Index>(i)));
  }
  factors_.solve(x);
  for (std::size_t i = 0; i < n; ++i) x[n + i] = system_.has_mass(i) ? cj_ * x[i] - b[i] : b[i];
}

}  // namespace strandyn::solver
