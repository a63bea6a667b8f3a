#include "strandyn/analysis/energy_balance.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::analysis {

using air::Vibration;
using air::Wind;

std::string_view describe(BalanceEnding ending) {
  switch (ending) {
    case BalanceEnding::balanced:
      return "wind power equals self-damping";
    case BalanceEnding::damping_stronger:
      return "no crossing: self-damping is the stronger at the smallest amplitude";
    case BalanceEnding::wind_stronger:
      return "no crossing: wind power is the stronger at the largest amplitude";
    case BalanceEnding::undefined:
      break;
  }
  return "a power is not a finite number";
}

Balance energy_balance(const Wind& wind, double frequency, const SelfDamping& damping, const BalanceOptions& options) {
  const double D = wind.diameter;
  const double lowest = options.lowest.value_or(wind.curve.lowest);
  const double highest = options.highest.value_or(wind.curve.highest);
  const auto surplus = [&](double a) {  // of the wind [W/m]
    const Vibration vibration{.antinode_amplitude = a * D, .frequency = frequency};
    return wind_power(wind, vibration) - damping(vibration);
  };

  Balance balance;
  double below = lowest, surplus_below = surplus(lowest);
  const bool wind_at_lowest = surplus_below > 0;
  double low = 0, high = 0;  // around the first crossing
  if (!std::isfinite(surplus_below)) return balance;
  for (int i = 1; i < options.samples; ++i) {
    const double a = lowest * std::pow(highest / lowest, static_cast<double>(i) / (options.samples - 1));
    const double surplus_here = surplus(a);
    if (!std::isfinite(surplus_here)) return {};
    if (surplus_below > 0 && surplus_here <= 0 && ++balance.crossings == 1) {
      low = below;
      high = a;
    }
    below = a;
    surplus_below = surplus_here;
  }
  if (balance.crossings == 0) {
    balance.ending = surplus_below > 0 ? BalanceEnding::wind_stronger : BalanceEnding::damping_stronger;
    return balance;
  }

  constexpr double tolerance = 1e-12;  // relative, of the amplitude
  while (high - low > tolerance * high) {
    const double middle = (low + high) / 2;
    (surplus(middle) > 0 ? low : high) = middle;
  }
  const double a = (low + high) / 2;
  balance.ending = BalanceEnding::balanced;
  balance.amplitude_over_diameter = a;
  balance.antinode_amplitude = a * D;
  balance.antinode_velocity = 2 * std::numbers::pi * frequency * a * D;
  balance.power = wind_power(wind, {.antinode_amplitude = a * D, .frequency = frequency});
  balance.from_lowest = wind_at_lowest;
  balance.within_curve = a >= wind.curve.lowest && a <= wind.curve.highest;
  return balance;
}

}  // namespace strandyn::analysis
