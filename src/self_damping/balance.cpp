#include "strandyn/self_damping/balance.hpp"

#include <algorithm>

#include "foti_2018.hpp"
#include "strandyn/analysis/bending_amplitude.hpp"
#include "strandyn/analysis/energy_balance.hpp"
#include "strandyn/analysis/published_laws.hpp"

namespace strandyn::self_damping {

using casefile::BalancedBy;
using casefile::Scene;

namespace {

const analysis::WindPowerCurve& curve_of(casefile::WindCurve wind) {
  switch (wind) {
    case casefile::WindCurve::diana_falco:
      return analysis::diana_falco();
    case casefile::WindCurve::brika_laneville:
      return analysis::brika_laneville();
    case casefile::WindCurve::cigre:
      break;
  }
  return analysis::cigre_cubic();
}

analysis::PowerLaw published_law(const Scene& scene, const casefile::EnergyBalanceKeys& balance) {
  const conductor::Strand& strand = scene.conductor->strand;
  const auto laws = analysis::published_laws();
  const auto& found = *std::ranges::find(laws, balance.law, &analysis::PublishedLaw::name);
  if (balance.factor) {
    return {.factor = *balance.factor,
            .amplitude = (found.amplitude.low + found.amplitude.high) / 2,
            .frequency = (found.frequency.low + found.frequency.high) / 2,
            .tension = (found.tension->low + found.tension->high) / 2};
  }
  return *analysis::law_for(found, {.diameter = strand.outer_diameter(),
                                    .mass_per_length = *casefile::mass_per_length(scene),
                                    .rated_strength = strand.rated_strength});
}

/// The self-damping of a balance at one tension: of the free span, a bare line being long.
analysis::SelfDamping damping_of(const BalanceInputs& inputs, const casefile::EnergyBalanceKeys& balance,
                                 double tension) {
  const auto by_method = [tension](auto method) -> analysis::SelfDamping {
    return [method, tension](const analysis::Vibration& v) {
      const PointResult result =
          method->at({.frequency = v.frequency, .antinode_amplitude = v.antinode_amplitude, .tension = tension}, {});
      return result.free_span.value_or(result.self_damping);
    };
  };
  const auto by_law = [tension](const analysis::PowerLaw& law) -> analysis::SelfDamping {
    return [law, tension](const analysis::Vibration& v) {
      return analysis::power(
          law, {.antinode_amplitude = v.antinode_amplitude, .frequency = v.frequency, .tension = tension});
    };
  };
  switch (balance.self_damping) {
    case BalancedBy::quadrature:
      return by_method(inputs.quadrature);
    case BalancedBy::foti_2018:
      return by_method(std::make_shared<const ClosedForm>(inputs.scene));
    case BalancedBy::fit:
      return by_law(*inputs.fit);
    case BalancedBy::published:
      break;
  }
  return by_law(published_law(inputs.scene, balance));
}

/// A/D from which a balance is looked for: where the lowest curve begins. A curve that begins higher goes on below, and
/// `within_curve` says so of a balance there.
constexpr double lowest_over_diameter = 0.01;

BalanceRow row_of(const Scene& scene, const casefile::EnergyBalanceKeys& keys, const analysis::Balance& balance,
                  double frequency, double tension) {
  const conductor::Strand& strand = scene.conductor->strand;
  const build::SectionNumbers numbers = build::section_numbers(scene);
  BalanceRow row{
      .wind = std::string(name_of(keys.wind)),
      .turbulence_intensity = keys.turbulence_intensity,
      .self_damping = std::string(name_of(keys.self_damping)),
      .tension = tension,
      .frequency = frequency,
      .wind_speed = analysis::wind_speed({.diameter = numbers.diameter, .strouhal = keys.strouhal}, frequency),
      .ending = std::string(analysis::describe(balance.ending))};
  if (keys.self_damping == BalancedBy::published) row.law = keys.law;
  if (balance.ending != analysis::BalanceEnding::balanced) return row;
  row.amplitude_over_diameter = balance.amplitude_over_diameter;
  row.antinode_amplitude = balance.antinode_amplitude;
  row.antinode_velocity = balance.antinode_velocity;
  row.power = balance.power;
  row.within_curve = balance.within_curve;
  row.from_lowest = balance.from_lowest;
  const analysis::ClampedEnd end = {.tension = tension, .EI_min = numbers.EI_min};
  row.bending_amplitude = analysis::bending_amplitude(
      end,
      {.antinode_amplitude = balance.antinode_amplitude, .loop_length = build::loop_length(scene, tension, frequency)});
  const conductor::Layer& surface = strand.layers.back();
  row.bending_stress =
      analysis::bending_stress(end, {.diameter = surface.diameter, .young = surface.young}, *row.bending_amplitude);
  return row;
}

}  // namespace

Balances energy_balances(const BalanceInputs& inputs) {
  const auto& a = inputs.scene.as<casefile::SelfDampingAnalysis>();
  Balances balances;
  for (std::size_t i = 0; i < a.energy_balances.size(); ++i) {
    const casefile::EnergyBalanceKeys& keys = a.energy_balances[i];
    if (keys.self_damping == BalancedBy::fit && !inputs.fit) {
      balances.warnings.emplace_back(
          "an energy balance asks for the fit, and the points determine none; it is left out");
      continue;
    }
    const analysis::Wind wind = {.curve = curve_of(keys.wind),
                                 .diameter = build::section_numbers(inputs.scene).diameter,
                                 .turbulence_intensity = keys.turbulence_intensity};
    for (double tension : distinct_tensions(inputs.points)) {
      const analysis::SelfDamping damping = damping_of(inputs, keys, tension);
      for (double frequency : keys.frequencies.empty() ? a.frequencies : keys.frequencies) {
        const analysis::Balance balance =
            analysis::energy_balance(wind, frequency, damping, {.lowest = lowest_over_diameter});
        balances.rows.push_back(row_of(inputs.scene, keys, balance, frequency, tension));
        balances.rows.back().number = i;
      }
    }
  }
  return balances;
}

results::Table table_of_balances(const std::vector<BalanceRow>& rows) {
  results::Table table({"balance", "tension_N", "frequency_Hz", "wind_speed_m_per_s", "amplitude_over_diameter",
                        "antinode_amplitude_m", "antinode_velocity_m_per_s", "power_W_per_m", "bending_amplitude_m",
                        "bending_stress_Pa"});
  for (const BalanceRow& row : rows) {
    if (!row.power) continue;
    table.append(std::array{static_cast<double>(row.number), row.tension, row.frequency, row.wind_speed,
                            *row.amplitude_over_diameter, *row.antinode_amplitude, *row.antinode_velocity, *row.power,
                            *row.bending_amplitude, *row.bending_stress});
  }
  return table;
}

}  // namespace strandyn::self_damping
