#include "integration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::study {

using casefile::Integrator;
using casefile::Method;

namespace {

double per_step_angle(double frequency, double step) {
  return 2 * std::numbers::pi * frequency * step;
}

solver::GeneralizedAlpha method_of(const Integrator& integrator) {
  return {.rho_inf = integrator.rho_inf};
}

}  // namespace

double numerical_damping_ratio(const Integrator& integrator, double frequency, double step) {
  const double angle = per_step_angle(frequency, step);
  if (integrator.method == Method::generalized_alpha) return method_of(integrator).damping_ratio(angle);
  return std::pow(angle, 3) / 4;
}

int choose_steps_per_cycle(const Integrator& integrator, const StepDemand& demand) {
  // Slip begins and ends within a cycle, at curvatures near the largest: with so many steps the friction is right to
  // half a percent. IDA's error is that of generalized-alpha at half the steps. More would cost and show nothing new.
  const int least = integrator.method == Method::ida ? 400 : 200;
  constexpr double most = 4000;
  if (demand.damping_ratio == 0) return least;
  // The damping goes with the third power of the angle per step.
  const double unit = numerical_damping_ratio(integrator, 1 / (2 * std::numbers::pi), 1);
  const double angle = unit > 0 ? std::cbrt(demand.share * demand.damping_ratio / unit) : 1;
  const double steps = std::clamp<double>(2 * std::numbers::pi / angle, least, most);
  return 4 * static_cast<int>(std::ceil(steps / 4));
}

solver::IntegratorSummary integrate(const Integrator& integrator, system::System& system,
                                    const solver::InitialMotion& initial, const solver::IntegratorOptions& options,
                                    std::span<observe::Observer* const> observers) {
  if (integrator.method == Method::ida) return solver::integrate_ida(system, initial, options, observers);
  return solver::integrate_generalized_alpha(system, initial, options, method_of(integrator), observers);
}

}  // namespace strandyn::study
