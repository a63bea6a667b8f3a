#include "strandyn/build/losses.hpp"

#include "strandyn/build/section_law.hpp"
#include "strandyn/section/material_damping.hpp"

namespace strandyn::build {

namespace {

struct Handbook {
  double expansion = 0;      // [1/K]
  double conductivity = 0;   // [W/(m K)]
  double heat_capacity = 0;  // [J/(kg K)]
  double density = 0;        // [kg/m^3]
};
constexpr Handbook aluminium{.expansion = 23e-6, .conductivity = 234, .heat_capacity = 900, .density = 2703};
constexpr Handbook steel{.expansion = 11.5e-6, .conductivity = 50, .heat_capacity = 480, .density = 7780};
constexpr double kelvin = 273.15;

section::Metal metal_of(const conductor::Layer& layer, const casefile::Material& keys) {
  const bool is_steel = layer.young >= casefile::steel_from;
  section::Metal metal{.loss_factor =
                           (is_steel ? keys.loss_factor_steel : keys.loss_factor_aluminium).value_or(keys.loss_factor)};
  if (!keys.thermoelastic) return metal;
  const Handbook& h = is_steel ? steel : aluminium;
  metal.thermal_strain = h.expansion;
  metal.heat_capacity = h.heat_capacity * h.density;
  metal.diffusivity = h.conductivity / metal.heat_capacity;
  return metal;
}

}  // namespace

section::MaterialBranches material_branches(const casefile::Scene& scene) {
  if (!scene.material) return {};
  const casefile::Material& keys = *scene.material;
  if (!casefile::needs_strand(scene.section.law)) {
    const SectionNumbers n = section_numbers(scene);
    return section::material_branches({n.EA, n.GJ, n.EI_max, n.EI_max}, keys.loss_factor);
  }
  const conductor::Strand& strand = scene.conductor->strand;
  std::vector<section::Metal> metals;
  for (const conductor::Layer& layer : strand.layers) metals.push_back(metal_of(layer, keys));
  return section::material_branches(
      strand, metals, keys.temperature + kelvin,
      scene.section.law == casefile::Law::slip ? section::Wires::slipping : section::Wires::sticking);
}

std::optional<model::Surroundings> surroundings(const casefile::Scene& scene) {
  if (!scene.air || scene.air->still.density == 0) return std::nullopt;
  const double conductor = scene.conductor ? scene.conductor->strand.outer_diameter() : 0;
  return model::Surroundings{.air = scene.air->still, .diameter = scene.air->diameter.value_or(conductor)};
}

}  // namespace strandyn::build
