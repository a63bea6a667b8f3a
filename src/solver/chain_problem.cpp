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
      K_(system.model().nodes.size()),
      G_(system.model().nodes.size()),
      right_side_(external_.size()),
      product_(external_.size()) {}

void ChainProblem::residual(double t, const double* y, const double* yp, double* f) {
  const std::size_t n = unknowns();
  std::copy(y, y + n, u_.data());
  std::copy(y + n, y + 2 * n, v_.data());
  std::copy(yp + n, yp + 2 * n, a_.data());
  system_.external_force(t, external_.data());
  double* balance = f + n;
  system_.internal_force(y, balance);
  system_.add_inertia_and_drag({.u = y, .v = y + n, .a = yp + n}, balance);
  for (std::size_t i = 0; i < n; ++i) {
    f[i] = system_.has_mass(i) ? yp[i] - y[n + i] : y[n + i];
    balance[i] = system_.is_held(i) ? y[i] : balance[i] - external_(static_cast<Eigen::Index>(i));
  }
}

void ChainProblem::refresh(double cj) {
  const system::Motion motion{.u = u_.data(), .v = v_.data(), .a = a_.data()};
  system_.internal_force(u_.data(), internal_.data(), K_);
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
  for (std::size_t i = 0; i < n; ++i) right_side_(static_cast<Eigen::Index>(i)) = system_.has_mass(i) ? b[i] : 0.0;
  G_.multiply(right_side_.data(), product_.data());
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = b[n + i] + (system_.is_held(i) ? 0.0 : product_(static_cast<Eigen::Index>(i)));
  }
  factors_.solve(x);
  for (std::size_t i = 0; i < n; ++i) x[n + i] = system_.has_mass(i) ? cj_ * x[i] - b[i] : b[i];
}

}  // namespace strandyn::solver
