#include "strandyn/span/trial_cycles.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace strandyn::span {

using std::numbers::pi;
using system::Vector;

TrialCycles::TrialCycles(const SpanAtRest& span, const Vector& shape, double frequency, Stop stop)
    : span_(span), trial_(span.built.model), shape_(shape), omega_(2 * pi * frequency), stop_(std::move(stop)) {
  const Vector unit = shape_;
  modal_mass_ = 2 * span.system.kinetic_energy(span.u.data(), unit.data());
}

double TrialCycles::loss(double amplitude) {
  constexpr int steps = 64;
  trial_.begin(span_.u);
  trial_.start_clock(0);
  double lost = 0;
  for (int i = 1; i <= 2 * steps; ++i) {
    end_if_asked(stop_);
    const Vector u = span_.u + amplitude * std::sin(2 * pi * i / steps) * shape_;
    const system::Accepted accepted = trial_.commit(u.data(), 2 * pi / omega_ * i / steps);
    if (i > steps) lost += accepted.friction + accepted.material;
  }
  const Vector velocity = amplitude * omega_ * shape_;
  const double mean_power =
      (span_.system.viscous_power(velocity.data()).total() + span_.system.air_power(velocity.data())) / 2;
  return lost + mean_power * 2 * pi / omega_;
}

double TrialCycles::damping_ratio(double amplitude) {
  const double energy = std::pow(amplitude * omega_, 2) * modal_mass_ / 2;
  return energy > 0 ? loss(amplitude) / (4 * pi * energy) : 0;
}

double TrialCycles::steady_amplitude(double force, double drive) {
  // The force's work grows with the amplitude, the loss faster: find where they cross.
  const double work = pi * std::abs(force * drive);  // [N] per cycle and metre
  if (work == 0) return 0;
  double low = std::log(1e-7);
  double high = std::log(1.0);
  for (int i = 0; i < 16; ++i) {
    const double middle = 0.5 * (low + high);
    const double amplitude = std::exp(middle);
    (loss(amplitude) < work * amplitude ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

double TrialCycles::decayed_amplitude(double amplitude, std::size_t cycles) {
  // In at most sixteen pieces of the decay, each with the damping of its beginning.
  constexpr double pieces = 16;
  const double piece = static_cast<double>(cycles) / pieces;
  for (int i = 0; i < static_cast<int>(pieces); ++i) amplitude *= std::exp(-2 * pi * damping_ratio(amplitude) * piece);
  return amplitude;
}

}  // namespace strandyn::span
