#include "integration.hpp"

#include <numbers>

namespace strandyn::study {

solver::TimeMethod method_of(const casefile::Integrator& integrator) {
  if (integrator.method == casefile::Method::ida) return solver::Ida{};
  return solver::GeneralizedAlpha{.rho_inf = integrator.rho_inf};
}

double angle_per_step(double frequency, double step) {
  return 2 * std::numbers::pi * frequency * step;
}

}  // namespace strandyn::study
