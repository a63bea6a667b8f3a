#include <algorithm>

#include "self_damping_parts.hpp"
#include "strandyn/analysis/bending_amplitude.hpp"
#include "strandyn/analysis/energy_balance.hpp"
#include "strandyn/analysis/published_laws.hpp"

namespace strandyn::study {

using casefile::BalancedBy;
using casefile::Scene;
using json = nlohmann::ordered_json;

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
  const auto by_road = [tension](Road road) -> analysis::SelfDamping {
    return [road = std::move(road), tension](const analysis::Vibration& v) {
      const PointResult result =
          road({.frequency = v.frequency, .antinode_amplitude = v.antinode_amplitude, .tension = tension});
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
      return by_road([quadrature = inputs.quadrature](const Point& point) { return (*quadrature)(point); });
    case BalancedBy::foti_2018:
      return by_road(simplified_road(inputs.scene));
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

json balance_json(const Scene& scene, const casefile::EnergyBalanceKeys& keys, const analysis::Balance& balance,
                  double frequency, double tension) {
  const conductor::Strand& strand = scene.conductor->strand;
  const build::SectionNumbers numbers = build::section_numbers(scene);
  json row = {{"wind", casefile::name_of(keys.wind)},
              {"turbulence_intensity", keys.turbulence_intensity},
              {"self_damping", casefile::name_of(keys.self_damping)}};
  if (keys.self_damping == BalancedBy::published) row["law"] = keys.law;
  row["tension_N"] = tension;
  row["frequency_Hz"] = frequency;
  row["wind_speed_m_per_s"] =
      analysis::wind_speed({.diameter = numbers.diameter, .strouhal = keys.strouhal}, frequency);
  row["ending"] = analysis::describe(balance.ending);
  if (balance.ending != analysis::BalanceEnding::balanced) return row;
  row["amplitude_over_diameter"] = balance.amplitude_over_diameter;
  row["antinode_amplitude_m"] = balance.antinode_amplitude;
  row["antinode_velocity_m_per_s"] = balance.antinode_velocity;
  row["power_W_per_m"] = balance.power;
  row["within_curve"] = balance.within_curve;
  row["from_lowest"] = balance.from_lowest;
  const analysis::ClampedEnd end = {.tension = tension, .EI_min = numbers.EI_min};
  const double loop = build::loop_length(scene, tension, frequency);
  const double bending =
      analysis::bending_amplitude(end, {.antinode_amplitude = balance.antinode_amplitude, .loop_length = loop});
  row["bending_amplitude_m"] = bending;
  const conductor::Layer& surface = strand.layers.back();
  row["bending_stress_Pa"] =
      analysis::bending_stress(end, {.diameter = surface.diameter, .young = surface.young}, bending);
  return row;
}

/// energy_balance.csv: what is balanced, with the number of its [[analysis.energy_balance]] table.
void add_table(const json& rows, const std::vector<std::size_t>& numbers, CaseResult& result) {
  const std::vector<std::string> columns = {"tension_N",
                                            "frequency_Hz",
                                            "wind_speed_m_per_s",
                                            "amplitude_over_diameter",
                                            "antinode_amplitude_m",
                                            "antinode_velocity_m_per_s",
                                            "power_W_per_m",
                                            "bending_amplitude_m",
                                            "bending_stress_Pa"};
  std::vector<std::string> names = {"balance"};
  names.insert(names.end(), columns.begin(), columns.end());
  results::Table table(names);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].contains("power_W_per_m")) continue;
    std::vector<double> values = {static_cast<double>(numbers[i])};
    for (const std::string& column : columns) values.push_back(rows[i][column]);
    table.append(values);
  }
  result.tables.push_back({"energy_balance.csv", std::move(table)});
}

}  // namespace

void add_energy_balances(const BalanceInputs& inputs, CaseResult& result) {
  const casefile::SelfDampingAnalysis& a = inputs.scene.analysis.self_damping;
  if (a.energy_balances.empty()) return;
  json rows = json::array();
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < a.energy_balances.size(); ++i) {
    const casefile::EnergyBalanceKeys& keys = a.energy_balances[i];
    if (keys.self_damping == BalancedBy::fit && !inputs.fit) {
      result.summary["warnings"].push_back(
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
        rows.push_back(balance_json(inputs.scene, keys, balance, frequency, tension));
        numbers.push_back(i);
      }
    }
  }
  result.summary["energy_balance"] = rows;
  add_table(rows, numbers, result);
}

}  // namespace strandyn::study
