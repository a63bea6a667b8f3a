#include "strandyn/analysis/steady.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::analysis {

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
    numerical += weight * cycles[i].numerical;
  }
  s.self_damping = s.dissipation * span.frequency / span.length;
  const double omega = 2 * std::numbers::pi * span.frequency;
  const double V = omega * s.antinode_amplitude;
  if (V > 0) s.damping_ratio = 2 * s.self_damping / (span.mass_per_length * omega * V * V);
  s.loss_factor = 2 * s.damping_ratio;
  if (s.dissipation + s.air > 0) s.numerical_share = std::abs(numerical) / (s.dissipation + s.air);
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

}  // namespace strandyn::analysis
