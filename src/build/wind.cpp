#include "strandyn/build/wind.hpp"

#include <algorithm>

namespace strandyn::build {

using casefile::Scene;
using casefile::WindKeys;

namespace {

double diameter_of(const Scene& scene) {
  const WindKeys& keys = scene.winds.front();
  return keys.diameter.value_or(casefile::outer_diameter(scene));
}

/// [m/s] that the history multiplies.
double reference_speed(const WindKeys& keys) {
  return keys.speed.value_or(1);
}

/// Linear between the rows, constant beyond them; 1 without rows.
double factor_at(const std::vector<std::array<double, 2>>& rows, double place) {
  if (rows.empty()) return 1;
  const auto after = std::ranges::upper_bound(rows, place, {}, [](const auto& row) { return row[0]; });
  if (after == rows.begin()) return rows.front()[1];
  if (after == rows.end()) return rows.back()[1];
  const auto& [from, low] = *(after - 1);
  const auto& [to, high] = *after;
  return low + (high - low) * (place - from) / (to - from);
}

}  // namespace

const air::WindPowerCurve& curve_of(casefile::WindCurve curve) {
  switch (curve) {
    case casefile::WindCurve::diana_falco:
      return air::diana_falco();
    case casefile::WindCurve::brika_laneville:
      return air::brika_laneville();
    case casefile::WindCurve::cigre:
      break;
  }
  return air::cigre_cubic();
}

std::optional<model::Wind> wind_of(const Scene& scene, const model::Model& model) {
  if (scene.winds.empty()) return std::nullopt;
  const WindKeys& keys = scene.winds.front();
  if (keys.model == casefile::WindModel::power_curve) {
    return model::LockedInWind{{.curve = curve_of(keys.curve),
                                .diameter = diameter_of(scene),
                                .turbulence_intensity = keys.turbulence_intensity}};
  }
  model::WakeWind wind;
  wind.wake = keys.wake;
  wind.speed = reference_speed(keys);
  wind.amplitude = keys.start_amplitude;
  wind.wake.diameter = diameter_of(scene);
  wind.wake.strouhal = keys.strouhal;
  if (!keys.history.empty()) wind.history = casefile::tabulated(keys.history);
  for (const double place : model::arc_lengths(model)) wind.shear.push_back(factor_at(keys.shear, place));
  const double mean = keys.history.empty() ? *keys.speed : keys.history.front()[1];
  // Gusts that are as fast as vortices are no gusts.
  const double shedding = air::shedding_frequency({.diameter = wind.wake.diameter, .strouhal = keys.strouhal}, mean);
  wind.gusts = air::Gusts({.intensity = keys.turbulence_intensity,
                           .length = keys.turbulence_length,
                           .speed = mean,
                           .highest = shedding / 4,
                           .seed = static_cast<std::uint32_t>(keys.seed.value_or(1))});
  if (keys.seed) wind.seed = static_cast<std::uint32_t>(*keys.seed);
  return wind;
}

std::vector<model::Body> air_that_moves_along(const model::Model& model) {
  std::vector<model::Body> bodies;
  const auto* wake = model.wind ? std::get_if<model::WakeWind>(&*model.wind) : nullptr;
  if (!wake || wake->wake.added_mass == 0) return bodies;
  for (const double length : model::node_lengths(model)) {
    bodies.push_back({.node = bodies.size(), .mass = wake->wake.mass_of_air() * length});
  }
  return bodies;
}

std::optional<double> shedding_frequency(const Scene& scene) {
  const WindKeys& keys = scene.winds.front();
  if (keys.mode) return std::nullopt;
  const double speed = keys.history.empty() ? *keys.speed : keys.history.front()[1];
  return air::shedding_frequency({.diameter = diameter_of(scene), .strouhal = keys.strouhal}, speed);
}

}  // namespace strandyn::build
