#pragma once
/// \file How far a conductor vibrates in the wind by the study's self-damping, bare or with dampers: wind energy
/// balances, where a damper stands best, and what a year of wind takes from the conductor at its clamp.

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
  std::optional<double> bare_amplitude{}, damper_power{}, damper_velocity{}, reflection{};
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
  v.value("bare_amplitude_over_diameter", b.bare_amplitude, {.what = "in balance without the dampers"});
  v.value("damper_power_W", b.damper_power, {.what = "of all dampers"});
  v.value("damper_velocity_m_per_s", b.damper_velocity, {.what = "peak, of the clamp that is shaken hardest"});
  v.value("reflection", b.reflection,
          {.what = "amplitude of the wave that comes back from the better damped end, over that which goes there"});
}

/// The first damper at one of the places that are tried.
struct PlacementRow {
  std::size_t number = 0;  ///< of its table
  double tension = 0, at = 0, largest_amplitude = 0, largest_stress = 0, worst_frequency = 0, coverage = 0;
  bool is_best = false;
};
template <class V>
void members(V& v, PlacementRow& p) {
  v.value("tension_N", p.tension, {.what = "the tension"});
  v.value("at_m", p.at, {.what = "of the first damper, from its support"});
  v.value("largest_amplitude_over_diameter", p.largest_amplitude, {.what = "over all frequencies"});
  v.value("largest_bending_stress_Pa", p.largest_stress, {.what = "over all frequencies, at a clamp"});
  v.value("worst_frequency_Hz", p.worst_frequency, {.what = "where that is"});
  v.value(
      "coverage", p.coverage,
      {.what = "part of the frequencies at which the stress stays below EPRI's endurance limit of ACSR: 8.5 MPa with "
               "several layers of aluminium, 22.5 MPa with one"});
  v.value("is_best", p.is_best, {.what = "whether its largest stress is the smallest of all places"});
}

/// What a year of wind does to the conductor at its clamp.
struct DamageRow {
  std::size_t number = 0;  ///< of its table
  double tension = 0, damage = 0;
  std::optional<double> years{};
};
template <class V>
void members(V& v, DamageRow& d) {
  v.value("tension_N", d.tension, {.what = "the tension"});
  v.value("damage_per_year", d.damage, {.what = "Miner's sum over CIGRE's safe border line; 1 is a life"});
  v.value("years", d.years, {.what = "until it is 1"});
}

struct BalanceInputs {
  const casefile::Scene& scene;
  const std::vector<Point>& points;
  const Quadrature* quadrature = nullptr;      ///< where a balance asks for it
  std::optional<analysis::PowerLaw> fit = {};  ///< of the study
};
struct Balances {
  std::vector<BalanceRow> rows;
  std::vector<PlacementRow> placements;
  std::vector<DamageRow> damages;
  std::vector<std::string> warnings;
};
Balances energy_balances(const BalanceInputs& inputs);
/// What is balanced, with the number of its table.
results::Table table_of_balances(const std::vector<BalanceRow>& rows);

}  // namespace strandyn::self_damping
