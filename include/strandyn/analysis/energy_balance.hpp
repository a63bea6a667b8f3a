#pragma once
/// \file How far a bare conductor vibrates: where the power of the wind equals its self-damping.        [CIGRE1989]
///
///     P_w(A, f) = P(A, f)   with P_w falling below P as A grows
/// A is the antinode amplitude, half of peak to peak. The difference is sampled over the range of the curve in equal
/// steps of ln A, and the first change from wind to damping is bisected: the amplitude at which a vibration that grows
/// from the bottom of the range stops. Two crossings between neighbouring samples are missed.

#include <functional>
#include <optional>
#include <string_view>

#include "strandyn/air/wind_power.hpp"

namespace strandyn::analysis {

/// Self-damping [W/m] at the tension of the case: a published law, a fit, a closed form, a table, a simulation.
using SelfDamping = std::function<double(const air::Vibration&)>;

enum class BalanceEnding {
  balanced,
  damping_stronger,  ///< no crossing: damping is the stronger at the smallest amplitude, vibration stays below
  wind_stronger,     ///< no crossing: the wind is the stronger at the largest amplitude, vibration goes beyond
  undefined          ///< one of the powers was not a finite number
};
std::string_view describe(BalanceEnding ending);

struct BalanceOptions {
  std::optional<double> lowest{};   ///< [-] A/D; the curve's own unless given
  std::optional<double> highest{};  ///< [-] A/D; the curve's own unless given
  int samples = 64;                 ///< at least 2
};

/// The numbers are zero unless balanced.
struct Balance {
  BalanceEnding ending = BalanceEnding::undefined;
  double amplitude_over_diameter = 0;  ///< [-] A/D
  double antinode_amplitude = 0;       ///< [m] A
  double antinode_velocity = 0;        ///< [m/s] 2 pi f A
  double power = 0;                    ///< [W/m] of the wind and of the damping
  int crossings = 0;                   ///< from wind to damping, in the whole range; the smallest amplitude is given
  bool from_lowest = false;            ///< the wind is the stronger all the way up; else a push must bring it there
  bool within_curve = false;           ///< A/D lies in the range that the curve was fitted on
};

Balance energy_balance(const air::Wind& wind, double frequency, const SelfDamping& damping,
                       const BalanceOptions& options = {});

}  // namespace strandyn::analysis
