#include "strandyn/analysis/decay_curve.hpp"

#include <algorithm>
#include <cmath>

#include "strandyn/analysis/methods.hpp"

namespace strandyn::analysis {

std::vector<DampingAtAmplitude> damping_against_amplitude(const std::vector<DecayingCycle>& cycles,
                                                          const SpanNumbers& span) {
  const auto still = std::ranges::find_if(cycles, [](const DecayingCycle& cycle) { return !(cycle.amplitude > 0); });
  const auto count = static_cast<std::size_t>(still - cycles.begin());
  std::vector<DampingAtAmplitude> curve;
  for (std::size_t i = 0; i < count; ++i) {
    const DecayingCycle& cycle = cycles[i];
    const DecayingCycle& before = cycles[i == 0 ? 0 : i - 1];
    const DecayingCycle& after = cycles[std::min(i + 1, count - 1)];
    DampingAtAmplitude at{.number = cycle.number, .amplitude = cycle.amplitude};
    if (after.number > before.number) {
      at.log_decrement = std::log(before.amplitude / after.amplitude) / (after.number - before.number);
    }
    at.power = cycle.lost * span.frequency / span.length;
    at.damping_ratio = damping_ratio_at(at.power, cycle.amplitude, span);
    at.loss_factor = loss_factor(at.damping_ratio);
    curve.push_back(at);
  }
  return curve;
}

std::optional<double> exponent_of_amplitude(const std::vector<DampingAtAmplitude>& curve) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, low = INFINITY, high = 0;
  for (const DampingAtAmplitude& at : curve) {
    if (!(at.power > 0)) continue;
    const double a = std::log(at.amplitude), p = std::log(at.power);
    n += 1, x += a, y += p, xx += a * a, xy += a * p;
    low = std::min(low, at.amplitude);
    high = std::max(high, at.amplitude);
  }
  constexpr double fewest = 3, least_range = 1.1;
  if (n < fewest || high < least_range * low) return std::nullopt;
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace strandyn::analysis
