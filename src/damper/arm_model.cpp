#include "arm_model.hpp"

#include <numbers>

namespace strandyn::damper {

using section::Component;

namespace {

/// [-] of the branch that stands for the metal: w tau. What it adds to the stiffness is this part of what it loses.
constexpr double slowness = 1e-3;
/// Along its axis the messenger hardly moves: bending alone counts.
section::MaterialBranches branch_at(const section::MaterialLoss& loss, double omega) {
  const double wanted = section::loss_at(loss, Component::bending2, omega);
  if (wanted == 0) return {};
  section::MaterialBranch branch{.relaxation_time = slowness / omega};
  branch.stiffness[static_cast<std::size_t>(Component::bending2)] = wanted * (1 + slowness * slowness) / slowness;
  return {branch};
}

}  // namespace

model::Model arm_model(const Arm& arm, const Messenger& messenger, std::size_t elements, double frequency) {
  model::Model model;
  model.freedom = model::Freedom::transverse_planar;
  std::vector<double> nodes;
  for (std::size_t i = 0; i <= elements; ++i) {
    nodes.push_back(arm.length * static_cast<double>(i) / static_cast<double>(elements));
  }
  model::lay_out(model, {.positions = nodes, .strain = 0});
  model.supports = {{.node = 0, .fixed = {true, true, true, true, true, true}}};
  model.bodies = {{.node = elements,
                   .mass = arm.weight.mass,
                   .inertia = arm.weight.inertia,
                   .eccentricity = {-arm.weight.eccentricity, 0}}};
  model.law = messenger.law;
  model.inertia = {.mass = messenger.mass_per_length, .rotary = 0};
  model.mass_matrix = model::MassMatrix::consistent;
  if (frequency > 0) model.material = branch_at(messenger.material, 2 * std::numbers::pi * frequency);
  return model;
}

}  // namespace strandyn::damper
