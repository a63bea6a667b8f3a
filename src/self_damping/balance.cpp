#include "strandyn/self_damping/balance.hpp"

#include <algorithm>

#include "foti_2018.hpp"
#include "strandyn/analysis/energy_balance.hpp"
#include "strandyn/analysis/published_laws.hpp"
#include "strandyn/build/clamp.hpp"
#include "strandyn/build/wind.hpp"
#include "strandyn/self_damping/protection.hpp"

namespace strandyn::self_damping {

using casefile::BalancedBy;
using casefile::Scene;

namespace {

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
    return [method, tension](const air::Vibration& v) {
      const PointResult result =
          method->at({.frequency = v.frequency, .antinode_amplitude = v.antinode_amplitude, .tension = tension}, {});
      return result.free_span.value_or(result.self_damping);
    };
  };
  const auto by_law = [tension](const analysis::PowerLaw& law) -> analysis::SelfDamping {
    return [law, tension](const air::Vibration& v) {
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

/// A table of balances at one tension.
class Line {
 public:
  Line(const BalanceInputs& inputs, const casefile::EnergyBalanceKeys& keys, double tension)
      : scene_(inputs.scene),
        keys_(keys),
        tension_(tension),
        numbers_(build::section_numbers(inputs.scene)),
        wind_{.curve = build::curve_of(keys.wind),
              .diameter = numbers_.diameter,
              .turbulence_intensity = keys.turbulence_intensity},
        self_damping_(damping_of(inputs, keys, tension)) {}

  analysis::Balance bare(double frequency) const {
    return analysis::energy_balance(wind_, frequency, self_damping_, {.lowest = lowest_over_diameter});
  }
  analysis::Balance with(const Protection& protection, double frequency) const {
    const analysis::SelfDamping all = [&](const air::Vibration& v) {
      return self_damping_(v) + protection.per_metre(v, tension_);
    };
    return analysis::energy_balance(wind_, frequency, all, {.lowest = lowest_over_diameter});
  }

  double wind_speed(double frequency) const { return air::wind_speed(cylinder(), frequency); }
  double frequency_at(double speed) const { return air::shedding_frequency(cylinder(), speed); }

  /// Peak to peak at 89 mm from a clamp whose loop has this antinode amplitude [m].
  double bending_amplitude(double amplitude, double frequency) const {
    return analysis::bending_amplitude(
        end(), {.antinode_amplitude = amplitude, .loop_length = build::loop_length(scene_, tension_, frequency)});
  }
  double bending_stress(double bending_amplitude) const {
    return analysis::bending_stress(end(), build::surface_wire(scene_.conductor->strand), bending_amplitude);
  }

  BalanceRow row(double frequency, const Protection* protection) const {
    const analysis::Balance balance = protection ? with(*protection, frequency) : bare(frequency);
    BalanceRow row{.wind = std::string(name_of(keys_.wind)),
                   .turbulence_intensity = keys_.turbulence_intensity,
                   .self_damping = std::string(name_of(keys_.self_damping)),
                   .tension = tension_,
                   .frequency = frequency,
                   .wind_speed = wind_speed(frequency),
                   .ending = std::string(analysis::describe(balance.ending))};
    if (keys_.self_damping == BalancedBy::published) row.law = keys_.law;
    if (balance.ending != analysis::BalanceEnding::balanced) return row;
    row.amplitude_over_diameter = balance.amplitude_over_diameter;
    row.antinode_amplitude = balance.antinode_amplitude;
    row.antinode_velocity = balance.antinode_velocity;
    row.power = balance.power;
    row.within_curve = balance.within_curve;
    row.from_lowest = balance.from_lowest;
    double at_clamp = balance.antinode_amplitude;
    if (protection) {
      const Protection::Taken taken =
          protection->at({.antinode_amplitude = balance.antinode_amplitude, .frequency = frequency}, tension_);
      at_clamp = taken.largest_end_amplitude;
      row.damper_power = taken.power;
      row.damper_velocity = taken.damper_velocity;
      row.reflection = taken.reflection;
      const analysis::Balance alone = bare(frequency);
      if (alone.ending == analysis::BalanceEnding::balanced) row.bare_amplitude = alone.amplitude_over_diameter;
    }
    row.bending_amplitude = bending_amplitude(at_clamp, frequency);
    row.bending_stress = bending_stress(*row.bending_amplitude);
    return row;
  }

 private:
  air::VortexShedding cylinder() const { return {.diameter = numbers_.diameter, .strouhal = keys_.strouhal}; }
  analysis::ClampedEnd end() const { return {.tension = tension_, .EI_min = numbers_.EI_min}; }

  const Scene& scene_;
  const casefile::EnergyBalanceKeys& keys_;
  double tension_;
  build::SectionNumbers numbers_;
  air::Wind wind_;
  analysis::SelfDamping self_damping_;
};

/// Where no balance is found vibration stays below the curve, and counts as none.
PlacementRow placement_of(const Line& line, const Protection& protection, const std::vector<double>& frequencies,
                          double endurance_limit) {
  PlacementRow placement;
  std::size_t covered = 0;
  for (const double frequency : frequencies) {
    const BalanceRow row = line.row(frequency, &protection);
    const double stress = row.bending_stress.value_or(0);
    if (stress < endurance_limit) ++covered;
    placement.largest_amplitude = std::max(placement.largest_amplitude, row.amplitude_over_diameter.value_or(0));
    if (stress <= placement.largest_stress) continue;
    placement.largest_stress = stress;
    placement.worst_frequency = frequency;
  }
  placement.coverage = static_cast<double>(covered) / static_cast<double>(frequencies.size());
  return placement;
}

/// All places of the first damper.
std::vector<PlacementRow> placements_of(const Line& line, const BalanceInputs& inputs,
                                        const casefile::EnergyBalanceKeys& keys,
                                        const std::vector<double>& frequencies) {
  std::vector<PlacementRow> rows;
  const casefile::PlaceScan& scan = *keys.damper_at;
  const double limit = fatigue::endurance_limit(build::aluminium_layers(inputs.scene.conductor->strand));
  for (int i = 0; i < scan.count; ++i) {
    const double at = scan.from + (scan.to - scan.from) * i / (scan.count - 1);
    rows.push_back(placement_of(line, Protection(inputs.scene, keys, at), frequencies, limit));
    rows.back().at = at;
  }
  std::ranges::min_element(rows, {}, &PlacementRow::largest_stress)->is_best = true;
  return rows;
}

DamageRow damage_of(const Line& line, const BalanceInputs& inputs, const casefile::EnergyBalanceKeys& keys,
                    const Protection* protection) {
  constexpr double seconds_an_hour = 3600;
  std::vector<fatigue::StressCycles> spectrum;
  for (const auto& [speed, hours] : keys.wind_hours) {
    const double frequency = line.frequency_at(speed);
    const BalanceRow row = line.row(frequency, protection);
    if (row.bending_stress) {
      spectrum.push_back({.stress = *row.bending_stress, .cycles = hours * seconds_an_hour * frequency});
    }
  }
  DamageRow row{.damage = fatigue::damage(build::aluminium_layers(inputs.scene.conductor->strand), spectrum)};
  if (row.damage > 0) row.years = 1 / row.damage;
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
    const std::vector<double>& frequencies = keys.frequencies.empty() ? a.frequencies : keys.frequencies;
    for (double tension : distinct_tensions(inputs.points)) {
      const Line line(inputs, keys, tension);
      std::optional<Protection> protection;
      if (!keys.dampers.empty()) protection.emplace(inputs.scene, keys);
      for (double frequency : frequencies) {
        balances.rows.push_back(line.row(frequency, protection ? &*protection : nullptr));
        balances.rows.back().number = i;
      }
      if (keys.damper_at) {
        for (PlacementRow& row : placements_of(line, inputs, keys, frequencies)) {
          row.number = i;
          row.tension = tension;
          balances.placements.push_back(row);
        }
      }
      if (keys.wind_hours.empty()) continue;
      balances.damages.push_back(damage_of(line, inputs, keys, protection ? &*protection : nullptr));
      balances.damages.back().number = i;
      balances.damages.back().tension = tension;
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
