#include "strandyn/analysis/steady.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/analysis/methods.hpp"

namespace strandyn::analysis {

double damping_ratio_at(double power, double antinode_amplitude, const SpanNumbers& span) {
  const double velocity = 2 * std::numbers::pi * span.frequency * antinode_amplitude;
  if (!(velocity > 0)) return 0;
  return damping_ratio(power,
                       {.mass_per_length = span.mass_per_length, .frequency = span.frequency, .velocity = velocity});
}

SteadyState steady_state(const std::vector<CycleLosses>& cycles, const SpanNumbers& span, std::size_t last) {
  SteadyState s;
  s.cycles = std::min(last, cycles.size());
  if (s.cycles == 0) return s;
  const double weight = 1 / static_cast<double>(s.cycles);
  double numerical = 0;
  for (std::size_t i = cycles.size() - s.cycles; i < cycles.size(); ++i) {
    s.antinode_amplitude += weight * cycles[i].antinode_amplitude;
    s.dissipation += weight * (cycles[i].friction + cycles[i].material + cycles[i].viscous);
    s.air += weight * cycles[i].air;
    s.dampers += weight * cycles[i].dampers;
    numerical += weight * cycles[i].numerical;
  }
  s.self_damping = s.dissipation * span.frequency / span.length;
  s.damping_ratio = damping_ratio_at(s.self_damping, s.antinode_amplitude, span);
  s.loss_factor = 2 * s.damping_ratio;
  const double lost = s.dissipation + s.air + s.dampers;
  if (lost > 0) s.numerical_share = std::abs(numerical) / lost;
  return s;
}

bool is_steady(std::span<const CycleFlow> cycles, double nothing) {
  if (cycles.empty()) return false;
  double low = cycles.front().amplitude;
  double high = low;
  double in = 0;
  double lost = 0;
  for (const CycleFlow& cycle : cycles) {
    low = std::min(low, cycle.amplitude);
    high = std::max(high, cycle.amplitude);
    in += cycle.in;
    lost += cycle.lost;
  }
  return high - low <= 2e-3 * high &&
         std::abs(in - lost) <= 5e-3 * std::abs(in) + nothing * static_cast<double>(cycles.size());
}

namespace {

/// Of the least-squares line from the first to the last, of the mean; 0 where that is.
double drift(std::span<const CycleFlow> cycles, double CycleFlow::*value) {
  const auto count = static_cast<double>(cycles.size());
  double mean = 0;
  for (const CycleFlow& cycle : cycles) mean += cycle.*value / count;
  double along = 0, squares = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const double x = static_cast<double>(i) - (count - 1) / 2;
    along += x * (cycles[i].*value - mean);
    squares += x * x;
  }
  return squares > 0 && mean != 0 ? along / squares * (count - 1) / mean : 0;
}

}  // namespace

Steadiness steadiness(std::span<const CycleFlow> cycles) {
  Steadiness found{.cycles = cycles.size(),
                   .amplitude_drift = drift(cycles, &CycleFlow::amplitude),
                   .loss_drift = drift(cycles, &CycleFlow::lost)};
  double in = 0, lost = 0;
  for (const CycleFlow& cycle : cycles) in += cycle.in, lost += cycle.lost;
  if (lost > 0) found.work_in_over_lost = in / lost;
  return found;
}

bool is_steady(const Steadiness& s) {
  constexpr double balance = 5e-3, loss = 5e-3, amplitude = 3e-3;
  return s.cycles >= cycles_that_show_steadiness && s.work_in_over_lost &&
         std::abs(*s.work_in_over_lost - 1) <= balance && std::abs(s.loss_drift) <= loss &&
         std::abs(s.amplitude_drift) <= amplitude;
}

}  // namespace strandyn::analysis
