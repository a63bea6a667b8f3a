#pragma once
/// \file How far a bare conductor vibrates in the wind by the study's self-damping: wind energy balances.

#include "strandyn/analysis/power_law.hpp"
#include "strandyn/self_damping/quadrature.hpp"

namespace strandyn::self_damping {

struct BalanceRow {
  std::size_t number = 0;  ///< of its [[analysis.energy_balance]] table
  std::string wind;
  double turbulence_intensity = 0;
  std::string self_damping;
  std::optional<std::string> law{};
  double tension = 0, frequency = 0, wind_speed = 0;
  std::string ending;
  std::optional<double> amplitude_over_diameter{}, antinode_amplitude{}, antinode_velocity{}, power{};
  std::optional<bool> within_curve{}, from_lowest{};
  std::optional<double> bending_amplitude{}, bending_stress{};
};
template <class V>
void members(V& v, BalanceRow& b) {
  v.value("wind", b.wind, {.what = "the curve of wind power"});
  v.value("turbulence_intensity", b.turbulence_intensity, {.what = "of the wind"});
  v.value("self_damping", b.self_damping, {.what = "what damps"});
  v.value("law", b.law, {.what = "the published law"});
  v.value("tension_N", b.tension, {.what = "the tension"});
  v.value("frequency_Hz", b.frequency, {.what = "the frequency"});
  v.value("wind_speed_m_per_s", b.wind_speed, {.what = "that sheds vortices at this frequency"});
  v.value("ending", b.ending, {.what = "balanced, or which side is the stronger throughout"});
  v.value("amplitude_over_diameter", b.amplitude_over_diameter, {.what = "in balance"});
  v.value("antinode_amplitude_m", b.antinode_amplitude, {.what = "in balance"});
  v.value("antinode_velocity_m_per_s", b.antinode_velocity, {.what = "in balance, peak"});
  v.value("power_W_per_m", b.power, {.what = "of the wind and of the damping"});
  v.value("within_curve", b.within_curve, {.what = "whether the amplitude lies where the wind's curve was fitted"});
  v.value("from_lowest", b.from_lowest, {.what = "whether the wind brings it there from the smallest amplitude"});
  v.value("bending_amplitude_m", b.bending_amplitude, {.what = "peak to peak at 89 mm from the clamp"});
  v.value("bending_stress_Pa", b.bending_stress, {.what = "amplitude in a surface wire, Poffenberger and Swart"});
}

struct BalanceInputs {
  const casefile::Scene& scene;
  const std::vector<Point>& points;
  const Quadrature* quadrature = nullptr;      ///< where a balance asks for it
  std::optional<analysis::PowerLaw> fit = {};  ///< of the study
};
struct Balances {
  std::vector<BalanceRow> rows;
  std::vector<std::string> warnings;
};
Balances energy_balances(const BalanceInputs& inputs);
/// What is balanced, with the number of its table.
results::Table table_of_balances(const std::vector<BalanceRow>& rows);

}  // namespace strandyn::self_damping
