#include "chain_problem.hpp"

#include <algorithm>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {

ChainProblem::ChainProblem(system::System& system, std::span<const model::Drive> drives)
    : system_(system),
      drives_(drives.begin(), drives.end()),
      scratch_(system.make_vector()),
      u_(scratch_),
      v_(scratch_),
      a_(scratch_),
      K_(system.make_matrix()),
      G_(system.make_matrix()),
      held_(system.make_vector()),
      held_rates_(held_),
      right_side_(scratch_),
      product_(scratch_) {}

void ChainProblem::residual(double t, const double* y, const double* yp, double* f, bool with_tangent) {
  const std::size_t n = unknowns();
  std::copy(y, y + n, u_.data());
  std::copy(y + n, y + 2 * n, v_.data());
  std::copy(yp + n, yp + 2 * n, a_.data());
  time_ = t;
  if (system_.has_moving_supports()) {
    system_.held_values(at(t), held_.data());
    system_.held_rates(at(t), held_rates_.data());
  }
  double* balance = f + n;
  const system::State state{.u = y, .v = y + n, .a = yp + n};
  if (with_tangent) {
    system_.residual(state, at(t), balance, K_);
  } else {
    system_.residual(state, at(t), balance);
  }
  tangent_at_hand_ = with_tangent;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    f[i] = system_.has_mass(i) ? yp[i] - y[n + i] : y[n + i] - held_rates_(k);
    if (system_.is_held(i)) balance[i] = y[i] - held_(k);
  }
}

bool ChainProblem::refresh(double cj) {
  const system::State state{.u = u_.data(), .v = v_.data(), .a = a_.data()};
  if (!tangent_at_hand_) system_.residual({.u = u_.data()}, at(time_), scratch_.data(), K_);
  tangent_at_hand_ = false;  // what follows makes another matrix of it
  system_.add_inertia_and_drag(state, {.acceleration = cj * cj, .velocity = cj, .position = 1}, K_);
  G_.set_zero();
  system_.add_inertia_and_drag(state, {.acceleration = cj, .velocity = 1, .position = 0}, G_);
  const Stopwatch::Lap lap(system_.stopwatch(), Part::factorization);
  system_.hold(K_);
  const bool done = factors_.factorize(K_);
  cj_ = done ? cj : 0;
  return done;
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

void ChainProblem::archive(Archive& a) {
  a(G_, factors_, cj_);
  if (!G_.fits_update() || (cj_ != 0 && !factors_.fit(K_)))
    throw FileError("the factors of its matrix are another system's");
}

}  // namespace strandyn::solver
