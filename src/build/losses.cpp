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
constexpr Handbook aluminium{
    .expansion = casefile::expansion_of_aluminium, .conductivity = 234, .heat_capacity = 900, .density = 2703};
constexpr Handbook steel{
    .expansion = casefile::expansion_of_steel, .conductivity = 50, .heat_capacity = 480, .density = 7780};
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

section::MaterialLoss of_sticking_wires(const casefile::Scene& scene, const casefile::Material& keys) {
  if (!casefile::needs_strand(scene.section.law)) {
    const SectionNumbers n = section_numbers(scene);
    return section::material_loss({n.EA, n.GJ, n.EI_max, n.EI_max}, keys.loss_factor);
  }
  const conductor::Strand& strand = scene.conductor->strand;
  std::vector<section::Metal> metals;
  for (const conductor::Layer& layer : strand.layers) metals.push_back(metal_of(layer, keys));
  return section::material_loss(
      strand, metals, keys.temperature + kelvin,
      scene.section.law == casefile::Law::slip ? section::Wires::slipping : section::Wires::sticking);
}

/// [-] bending stiffness of the law at rest over that which its branches are made for.
double stiffness_at_rest(const casefile::Scene& scene, double tension) {
  using section::Component;
  const SectionNumbers n = section_numbers(scene);
  const auto law = build_law(scene, section::Dimension::planar);
  section::Field strains(section::Dimension::planar, 1);
  strains[Component::axial][0] = tension / n.EA;
  section::Field stresses = strains;
  section::TangentField tangents(section::Dimension::planar, 1);
  law->respond(law->start(strains), strains, stresses, &tangents);
  const bool slips = scene.section.law == casefile::Law::slip;
  return tangents(Component::bending2, Component::bending2)[0] / (slips ? n.EI_min : n.EI_max);
}

}  // namespace

section::MaterialLoss material_loss(const casefile::Scene& scene, double tension) {
  if (!scene.material) return {};
  section::MaterialLoss loss = of_sticking_wires(scene, *scene.material);
  const double share = stiffness_at_rest(scene, tension);
  for (const auto c : {section::Component::bending2, section::Component::bending3}) {
    loss.constant[static_cast<std::size_t>(c)] *= share;
  }
  return loss;
}

std::optional<model::Surroundings> surroundings(const casefile::Scene& scene) {
  if (!scene.air || scene.air->still.density == 0) return std::nullopt;
  return model::Surroundings{.air = scene.air->still,
                             .diameter = scene.air->diameter.value_or(casefile::outer_diameter(scene))};
}

}  // namespace strandyn::build
