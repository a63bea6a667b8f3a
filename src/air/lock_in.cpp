#include "strandyn/air/lock_in.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace strandyn::air {

namespace {

using std::numbers::pi;

struct Pair {
  Pair(const WakeModel& wake, const CylinderOnSprings& cylinder, double speed)
      : omega_f(wake.angular_frequency(speed)),
        omega(2 * pi * cylinder.frequency),
        mass(cylinder.mass),
        damping(2 * mass * cylinder.damping_ratio * omega + wake.damping(speed)),
        lift(wake.lift_per_q(speed)),
        coupling(wake.coupling / wake.diameter),
        epsilon(wake.epsilon) {}

  /// [m] of the cylinder for q = 1.
  std::complex<double> answer(double W) const {
    return lift / std::complex(mass * (omega * omega - W * W), W * damping);
  }
  double detuning(double W) const { return omega_f * omega_f - W * W * (1 - coupling * answer(W).real()); }

  double omega_f, omega, mass, damping, lift, coupling, epsilon;
};

}  // namespace

std::vector<LockedIn> lock_in(const WakeModel& wake, const CylinderOnSprings& cylinder, double speed) {
  const Pair pair(wake, cylinder, speed);
  std::vector<LockedIn> found;
  // Where a root can lie: the resonance of a light damping is narrow, so steps are finer there than its width.
  const double width = std::max(1e-12 * pair.omega, pair.damping / pair.mass);
  std::vector<double> grid;
  for (int i = 0; i <= 4000; ++i) grid.push_back(std::max(pair.omega, pair.omega_f) * 3 * i / 4000.0);
  for (int i = -4000; i <= 4000; ++i) {
    const double far = std::sinh(i / 4000.0 * std::asinh(pair.omega / width));
    grid.push_back(pair.omega + far * width);
  }
  std::erase_if(grid, [](double W) { return W <= 0; });
  std::ranges::sort(grid);
  for (std::size_t i = 1; i < grid.size(); ++i) {
    double low = grid[i - 1], high = grid[i];
    const double at_low = pair.detuning(low);
    if (std::signbit(at_low) == std::signbit(pair.detuning(high))) continue;
    for (int k = 0; k < 100; ++k) {
      const double middle = (low + high) / 2;
      (std::signbit(pair.detuning(middle)) == std::signbit(at_low) ? low : high) = middle;
    }
    const double W = (low + high) / 2;
    const std::complex<double> G = pair.answer(W);
    const double square = 4 * (1 - pair.coupling * W * G.imag() / (pair.epsilon * pair.omega_f));
    if (square <= 0) continue;
    const double q = std::sqrt(square);
    found.push_back({.frequency = W / (2 * pi), .amplitude = q * std::abs(G), .wake_amplitude = q});
  }
  return found;
}

}  // namespace strandyn::air
