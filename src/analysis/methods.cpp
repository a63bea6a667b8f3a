#include "strandyn/analysis/methods.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::analysis {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

double damping_ratio(double power_per_length, const Antinode& antinode) {
  const double omega = two_pi * antinode.frequency;
  return 2 * power_per_length / (antinode.mass_per_length * omega * antinode.velocity * antinode.velocity);
}

double power_per_length(double damping_ratio, const Antinode& antinode) {
  const double omega = two_pi * antinode.frequency;
  return damping_ratio * antinode.mass_per_length * omega * antinode.velocity * antinode.velocity / 2;
}

double loss_factor(double damping_ratio) {
  return 2 * damping_ratio;
}

double drive_power(const Drive& drive) {
  return drive.force * drive.velocity * std::cos(drive.phase) / 2;
}

double drive_power(std::complex<double> force, std::complex<double> velocity) {
  return (force.real() * velocity.real() + force.imag() * velocity.imag()) / 2;
}

double power_method(const Drive& drive, double length) {
  return drive_power(drive) / length;
}

double power_method(const CycleWork& cycle, double length) {
  return cycle.work * cycle.frequency / length;
}

double logarithmic_decrement(const Decay& decay) {
  return std::log(decay.first_amplitude / decay.last_amplitude) / decay.cycles;
}

std::optional<DecrementFit> fit_decrement(std::span<const double> amplitudes) {
  const std::size_t n = amplitudes.size();
  if (n < 2) return {};
  const double middle = (static_cast<double>(n) - 1) / 2;
  double mean = 0;
  for (const double Y : amplitudes) {
    if (!(Y > 0) || !std::isfinite(Y)) return {};
    mean += std::log(Y) / static_cast<double>(n);
  }
  double across = 0, spread = 0;  // sums of (i - middle) (ln Y - mean) and (i - middle)^2
  for (std::size_t i = 0; i < n; ++i) {
    const double from_middle = static_cast<double>(i) - middle;
    across += from_middle * (std::log(amplitudes[i]) - mean);
    spread += from_middle * from_middle;
  }
  const double slope = across / spread;
  DecrementFit fit{.decrement = -slope, .first_amplitude = std::exp(mean - slope * middle)};
  if (n > 2) {
    double residual = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double off = std::log(amplitudes[i]) - mean - slope * (static_cast<double>(i) - middle);
      residual += off * off;
    }
    fit.standard_error = std::sqrt(residual / static_cast<double>(n - 2) / spread);
  }
  return fit;
}

double decay_method(double decrement, const Antinode& antinode) {
  return antinode.mass_per_length * antinode.frequency * decrement * antinode.velocity * antinode.velocity / 2;
}

double damping_ratio_of_decrement(double decrement) {
  return decrement / std::hypot(two_pi, decrement);
}

double wavenumber(const WaveGuide& guide, double frequency) {
  const double omega = two_pi * frequency;
  const double inertia = guide.mass_per_length * omega * omega;
  // The positive root of EI k^4 + T k^2 = m omega^2, written so that EI = 0 is no exception.
  const double root = std::sqrt(guide.tension * guide.tension + 4 * guide.EI * inertia);
  return std::sqrt(2 * inertia / (guide.tension + root));
}

double loop_length(const WaveGuide& guide, double frequency) {
  return std::numbers::pi / wavenumber(guide, frequency);
}

double wave_impedance(const WaveGuide& guide, double frequency) {
  const double k = wavenumber(guide, frequency);
  return k * (guide.tension + 2 * guide.EI * k * k) / (two_pi * frequency);
}

double inverse_standing_wave_ratio(const NodeReading& node) {
  return node.node_amplitude / node.antinode_amplitude;
}

double power_at_node(const NodeReading& node, const WaveGuide& guide, double frequency) {
  const double V = two_pi * frequency * node.antinode_amplitude;
  return inverse_standing_wave_ratio(node) * wave_impedance(guide, frequency) * V * V / 2;
}

double iswr_method(const NodePair& nodes, const WaveGuide& guide, double frequency) {
  const double lost = power_at_node(nodes.near, guide, frequency) - power_at_node(nodes.far, guide, frequency);
  return lost / nodes.distance;
}

}  // namespace strandyn::analysis
