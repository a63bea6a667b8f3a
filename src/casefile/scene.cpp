#include "strandyn/casefile/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::casefile {
namespace {

double rated_strength(const Scene& scene) {
  return scene.conductor ? scene.conductor->strand.rated_strength : 0;
}

}  // namespace

double Span::total_length() const {
  double sum = length.value_or(0.0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    sum += std::hypot(nodes[i][0] - nodes[i - 1][0], nodes[i][1] - nodes[i - 1][1], nodes[i][2] - nodes[i - 1][2]);
  }
  return sum;
}

std::optional<double> target_error(const Scene& scene) {
  if (!scene.accuracy) return std::nullopt;
  if (const double* number = std::get_if<double>(&*scene.accuracy)) return *number;
  const std::string* word = std::get_if<std::string>(&*scene.accuracy);
  const auto named = std::ranges::find_if(named_errors, [&](const NamedError& e) { return word && *word == e.name; });
  if (named == named_errors.end()) return std::nullopt;
  return named->value;
}

std::optional<double> span_tension(const Scene& scene) {
  if (!scene.span) return std::nullopt;
  if (scene.span->tension_rts) return *scene.span->tension_rts * rated_strength(scene);
  return scene.span->tension;
}

std::vector<double> section_tensions(const Scene& scene) {
  const auto& section = scene.as<SectionAnalysis>();
  std::vector<double> tensions = section.tensions;
  for (const double part : section.tensions_rts) tensions.push_back(part * rated_strength(scene));
  return tensions;
}

bool SelfDampingAnalysis::names_modes() const {
  return !modes.empty() || std::ranges::any_of(at, [](const DampingAt& point) { return point.mode.has_value(); });
}

bool SelfDampingAnalysis::takes(DampingMethod wanted) const {
  if (has_grid() && method == wanted) return true;
  return std::ranges::any_of(at, [&](const DampingAt& point) { return point.method.value_or(method) == wanted; });
}

std::optional<std::size_t> first_static_force(const Scene& scene) {
  const auto first = std::ranges::find(scene.loads, LoadType::static_force, &Load::type);
  if (first == scene.loads.end()) return std::nullopt;
  return static_cast<std::size_t>(first - scene.loads.begin());
}

std::optional<double> strung_mass_per_length(const Scene& scene) {
  if (scene.section.mass_per_length) return scene.section.mass_per_length;
  if (scene.conductor && scene.conductor->strand.mass_per_length > 0) return scene.conductor->strand.mass_per_length;
  return std::nullopt;
}

std::optional<double> mass_per_length(const Scene& scene) {
  const std::optional<double> strung = strung_mass_per_length(scene);
  if (!strung || !scene.span) return strung;
  return *strung / (1 + thermal_strain(scene)) + scene.span->ice;
}

double outer_diameter(const Scene& scene) {
  if (!scene.conductor) return 0;
  const double bare = scene.conductor->strand.outer_diameter();
  if (!scene.span || scene.span->ice == 0) return bare;
  return std::sqrt(bare * bare + 4 / std::numbers::pi * scene.span->ice / scene.span->ice_density);
}

double thermal_strain(const Scene& scene) {
  if (!scene.span || !scene.span->temperature) return 0;
  const double rise = *scene.span->temperature - scene.span->stringing_temperature;
  if (scene.span->expansion) return *scene.span->expansion * rise;
  if (!scene.conductor) return 0;
  double stiffness = 0, push = 0;
  for (const conductor::Layer& layer : scene.conductor->strand.layers) {
    const double c = std::cos(layer.lay_angle);
    const double EA = layer.wires * layer.young * layer.wire_area * c * c * c;
    stiffness += EA;
    push += EA * (layer.young >= steel_from ? expansion_of_steel : expansion_of_aluminium);
  }
  return stiffness > 0 ? push / stiffness * rise : 0;
}

}  // namespace strandyn::casefile
