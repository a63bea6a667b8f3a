#include "strandyn/analysis/bending_amplitude.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::analysis {
namespace {

/// (exp(-z) - 1 + z)/z^2: 1/2 at zero.
double end_shape(double z) {
  // The difference cancels for small z; there five terms of the series are exact to 1e-11.
  if (z < 0.03) return 0.5 - z * (1.0 / 6 - z * (1.0 / 24 - z * (1.0 / 120 - z / 720)));
  return (std::expm1(-z) + z) / (z * z);
}

}  // namespace

double stress_per_bending_amplitude(const ClampedEnd& end, const SurfaceWire& wire) {
  const double x = end.distance;
  const double p = std::sqrt(end.tension / end.EI_min);
  return wire.diameter * wire.young / (4 * x * x * end_shape(p * x));
}

double bending_stress(const ClampedEnd& end, const SurfaceWire& wire, double bending_amplitude) {
  return stress_per_bending_amplitude(end, wire) * bending_amplitude;
}

double bending_amplitude(const ClampedEnd& end, const LoopVibration& vibration) {
  const double x = end.distance;
  const double k = std::numbers::pi / vibration.loop_length;
  const double q = std::sqrt(k * k + end.tension / end.EI_min);
  // cos(k x) - exp(-q x) as two differences from 1, each without cancellation.
  const double half_sine = std::sin(k * x / 2);
  const double bracket = std::sin(k * x) - k / q * (-2 * half_sine * half_sine - std::expm1(-q * x));
  return 2 * vibration.antinode_amplitude / std::hypot(1.0, k / q) * bracket;
}

}  // namespace strandyn::analysis
