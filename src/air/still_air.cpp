#include "strandyn/air/still_air.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::air {

using std::numbers::pi;

double AirForce::power_of_sine(double velocity) const {
  const double square = velocity * velocity;
  return square * (linear / 2 + velocity * (quadratic * 4 / (3 * pi) + velocity * cubic * 3 / 8));
}

double AirForce::power_of_loop(double velocity) const {
  // Means of |sin|^2, |sin|^3, |sin|^4: 1/2, 4/(3 pi), 3/8.
  const double square = velocity * velocity;
  return square * (linear / 4 + velocity * (quadratic * 16 / (9 * pi * pi) + velocity * cubic * 9 / 64));
}

double attached_flow(const StillAir& air, double diameter, double frequency) {
  const double omega = 2 * pi * frequency;
  const double beta = diameter * diameter * frequency / air.viscosity;
  const double s = 1 / std::sqrt(pi * beta);
  return 2 * pi * diameter * air.density * std::sqrt(air.viscosity * omega / 2) * (1 + s - s * s / 4);
}

AirForce force_at(const StillAir& air, double diameter, double frequency) {
  return {.linear = attached_flow(air, diameter, frequency),
          .quadratic = air.density * diameter * air.drag_coefficient / 2,
          .cubic = 16 * air.density * air.drag_per_K / (9 * pi * frequency)};
}

double honji_limit(const StillAir& air, double diameter, double frequency) {
  const double root = std::pow(diameter * diameter * frequency / air.viscosity, -0.25);
  return 5.778 * root * (1 + 0.205 * root);
}

}  // namespace strandyn::air
