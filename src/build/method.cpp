#include "strandyn/build/method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::build {

using casefile::Method;
using casefile::StepRule;

namespace {

solver::TimeMethod method_of(const casefile::Integrator& keys) {
  if (keys.method == Method::ida) return solver::Ida{};
  return solver::GeneralizedAlpha{.rho_inf = keys.rho_inf};
}

}  // namespace

Integration::Integration(const casefile::Scene& scene) : keys_(scene.integrator), method_(method_of(keys_)) {
  if (keys_.method == Method::ida || keys_.step != StepRule::adaptive) return;
  refuse(scene.source, "integrator.step", "generalized-alpha takes steps of equal length",
         "use \"fixed\" or \"auto\", or method = \"ida\"");
}

double Integration::step_at(double frequency) const {
  return keys_.step_size.value_or(1 / (frequency * keys_.steps_per_cycle.value_or(casefile::default_steps_per_cycle)));
}

double Integration::damping_ratio(double frequency, double step) const {
  return solver::damping_ratio(method_, 2 * std::numbers::pi * frequency * step);
}

double Integration::more_steps(double numerical, double quadrature_error, double allowed) const {
  const double damping = std::abs(numerical + quadrature_error) / allowed;
  const double own = keys_.method == Method::ida ? std::cbrt(damping) : std::sqrt(damping);
  return std::max(own, quadrature_error / allowed);
}

solver::IntegratorOptions Integration::options(double step, double end_time, std::vector<model::Drive> drives,
                                               double frequency) const {
  return {.step = step,
          .end_time = end_time,
          .newton_tolerance = keys_.newton_tolerance,
          .relative_error = controls_error() ? keys_.rtol : 0,
          .fitted_frequency = keys_.fits_frequency ? frequency : 0,
          .stop = {},
          .drives = std::move(drives)};
}

}  // namespace strandyn::build
