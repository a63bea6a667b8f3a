#include "strandyn/exact/foti_2018.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::exact {
namespace {

// 1/3 - (3/8) cos t + (1/24) cos 3t = (2/3) sin^4(t/2) (2 + cos t): no cancellation where few sections stay below.
double cubic_share(double t) {
  return 2.0 / 3 * std::pow(std::sin(t / 2), 4) * (2 + std::cos(t));
}

}  // namespace

double loss_per_cycle(const Foti2018& conductor, double curvature_amplitude) {
  const double chi = std::abs(curvature_amplitude);
  return conductor.EI * chi * chi / 2 * std::min(1.0, chi / conductor.chi_0);
}

double self_damping(const Foti2018& conductor, const SineVibration& vibration) {
  constexpr double pi = std::numbers::pi;
  const double f = vibration.frequency;
  const double k_squared = 4 * pi * pi * conductor.mass_per_length * f * f / conductor.tension;  // [1/m^2]
  const double chi = k_squared * std::abs(vibration.antinode_amplitude);
  if (chi == 0) return 0;
  const double t = std::asin(std::min(1.0, conductor.chi_0 / chi));  // 2 pi kn
  const double G_1 = cubic_share(t);
  const double G_2 = pi - 2 * t + std::sin(2 * t);
  // The two terms of P, written with chi = 4 pi^2 m f^2 y/T.
  return conductor.EI * f * chi * chi / (4 * pi) * (8 * G_1 * chi / conductor.chi_0 + G_2);
}

}  // namespace strandyn::exact
