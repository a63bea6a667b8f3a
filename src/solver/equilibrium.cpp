#include "strandyn/solver/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using system::Matrix;
using system::System;
using system::Vector;

namespace {

struct Residual {
  Vector force;        // f_ext - f_int of the free unknowns
  double largest = 0;  // [N]
  std::size_t worst = 0;
};

Residual residual_of(const System& system, const Vector& load, const Vector& internal) {
  Residual r{.force = load - internal};
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    double& value = r.force(static_cast<Eigen::Index>(i));
    if (system.is_held(i)) value = 0;
    if (!(std::abs(value) <= r.largest)) {
      r.largest = std::abs(value);
      r.worst = i;
    }
    if (std::isnan(value)) break;  // nothing that follows is worse
  }
  return r;
}

/// Is a correction of u too small to say anything? Without tension, what rounding leaves of the large axial stiffness
/// may exceed any fraction of the forces at work.
bool is_rounding(const System& system, const Vector& correction, const Vector& u) {
  double reach = 0;  // [m]
  for (const beam::PlanarElement& element : system.model().elements) reach = std::max(reach, element.length);
  constexpr double relative = 1e-11;
  for (Eigen::Index node = 0; node < u.size(); node += static_cast<Eigen::Index>(model::unknowns_per_node)) {
    reach = std::max(reach, u.segment<2>(node).lpNorm<Eigen::Infinity>());
  }
  for (Eigen::Index node = 0; node < u.size(); node += static_cast<Eigen::Index>(model::unknowns_per_node)) {
    if (!(correction.segment<2>(node).lpNorm<Eigen::Infinity>() <= relative * reach)) return false;
    if (!(std::abs(correction(node + 2)) <= relative)) return false;
  }
  return true;
}

struct Attempt {
  bool converged = false;
  int iterations = 0;
  Residual residual;
};

Attempt iterate(const System& system, Vector& u, const Vector& load, const EquilibriumOptions& options) {
  Attempt attempt;
  Vector internal(u.size());
  Matrix K(system.model().nodes.size());
  math::BlockTridiagonalLU<static_cast<int>(model::unknowns_per_node)> factors;
  bool settled = false;
  for (attempt.iterations = 0; attempt.iterations <= options.max_iterations; ++attempt.iterations) {
    system.internal_force(u.data(), internal.data(), K);
    attempt.residual = residual_of(system, load, internal);
    if (!std::isfinite(attempt.residual.largest)) return attempt;
    // Forces that are held in equilibrium, the tension first of all, set the scale of what rounding leaves over.
    const double scale = internal.lpNorm<Eigen::Infinity>() + load.lpNorm<Eigen::Infinity>();
    if (settled || attempt.residual.largest <= options.tolerance * scale) {
      attempt.converged = true;
      return attempt;
    }
    system.hold(K);
    if (!factors.factorize(K)) return attempt;
    factors.solve(attempt.residual.force.data());
    u += attempt.residual.force;
    settled = is_rounding(system, attempt.residual.force, u);
  }
  return attempt;
}

}  // namespace

EquilibriumSummary find_equilibrium(System& system, Vector& u, const EquilibriumOptions& options) {
  Vector load(u.size());
  system.external_force(0, load.data());
  EquilibriumSummary summary;
  const double full_step = 1.0 / options.steps;
  double reached = 0;
  double step = full_step;
  while (reached < 1 - 1e-12) {
    const double target = std::min(1.0, reached + step);
    Vector trial = u;
    const Attempt attempt = iterate(system, trial, target * load, options);
    if (attempt.converged) {
      u = trial;
      system.commit(u.data());
      reached = target;
      step = full_step;
      const AlignedVector& dissipated = system.step_energy().dissipated;
      const auto slipping = std::count_if(dissipated.begin(), dissipated.end(), [](double loss) { return loss > 0; });
      summary.steps.push_back({.load_factor = reached,
                               .iterations = attempt.iterations,
                               .residual = attempt.residual.largest,
                               .sections_slipping = static_cast<std::size_t>(slipping),
                               .u = u});
      continue;
    }
    step /= 2;
    if (step < full_step * options.smallest_step) {
      throw ComputationError(fmt::format(
          "no static equilibrium at load factor {:.6g}: after {} iterations the largest residual is {:.3g} N at {}; "
          "use more load steps ([static] steps), or check the supports and the tension",
          target, attempt.iterations, attempt.residual.largest, model::unknown_name(attempt.residual.worst)));
    }
  }
  return summary;
}

}  // namespace strandyn::solver
