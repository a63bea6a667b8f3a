#include "strandyn/build/method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::build {

using casefile::Method;
using casefile::StepRule;

namespace {

constexpr double turn = 2 * std::numbers::pi;

solver::GeneralizedAlpha alpha_of(const casefile::Integrator& keys) {
  return {.rho_inf = keys.rho_inf};
}

}  // namespace

Integration::Integration(const casefile::Scene& scene) : keys_(scene.integrator) {
  if (keys_.method == Method::ida || keys_.step != StepRule::adaptive) return;
  refuse(scene.source, "integrator.step", "generalized-alpha takes steps of equal length",
         "use \"fixed\" or \"auto\", or method = \"ida\"");
}

double Integration::step_at(double frequency) const {
  return keys_.step_size.value_or(1 / (frequency * keys_.steps_per_cycle.value_or(200)));
}

double Integration::damping_ratio(double frequency, double step) const {
  const double angle = turn * frequency * step;
  if (keys_.method == Method::generalized_alpha) return alpha_of(keys_).damping_ratio(angle);
  return std::pow(angle, 3) / 4;
}

int Integration::choose_steps_per_cycle(const StepDemand& demand) const {
  // Slip begins and ends within a cycle, at curvatures near the largest: with so many steps the friction is right to
  // half a percent. IDA's error is that of generalized-alpha at half the steps. More would cost and show nothing new.
  const int least = keys_.method == Method::ida ? 400 : 200;
  constexpr double most = 4000;
  if (demand.damping_ratio == 0) return least;
  // The damping goes with the third power of the angle per step.
  const double unit = damping_ratio(1 / turn, 1);
  const double angle = unit > 0 ? std::cbrt(demand.share * demand.damping_ratio / unit) : 1;
  const double steps = std::clamp<double>(turn / angle, least, most);
  return 4 * static_cast<int>(std::ceil(steps / 4));
}

double Integration::more_steps(double numerical, double quadrature_error, double allowed) const {
  const double damping = std::abs(numerical + quadrature_error) / allowed;
  const double own = keys_.method == Method::ida ? std::cbrt(damping) : std::sqrt(damping);
  return std::max(own, quadrature_error / allowed);
}

solver::IntegratorOptions Integration::options(double step, double end_time) const {
  return {.step = step,
          .end_time = end_time,
          .newton_tolerance = keys_.newton_tolerance,
          .relative_error = controls_error() ? keys_.rtol : 0,
          .stop = {}};
}

solver::IntegratorSummary Integration::run(system::System& system, const solver::InitialMotion& initial,
                                           const solver::IntegratorOptions& options,
                                           std::span<observe::Observer* const> observers) const {
  if (keys_.method == Method::ida) return solver::integrate_ida(system, initial, options, observers);
  return solver::integrate_generalized_alpha(system, initial, options, alpha_of(keys_), observers);
}

}  // namespace strandyn::build
