#include "strandyn/build/dampers.hpp"

#include "strandyn/section/linear_law.hpp"

namespace strandyn::build {

std::vector<damper::HangingArm> arms_of(const casefile::DamperKeys& keys) {
  std::vector<damper::HangingArm> arms;
  for (std::size_t i = 0; i < keys.lengths.size(); ++i) {
    const damper::Weight weight{.mass = keys.masses[i], .inertia = keys.inertias[i], .eccentricity = keys.offsets[i]};
    arms.push_back({.arm = {.length = keys.lengths[i], .weight = weight},
                    .side = i == 0 ? damper::Side::left : damper::Side::right});
  }
  return arms;
}

damper::Messenger messenger_of(const casefile::DamperKeys& keys) {
  const double EI = keys.messenger->bending_stiffness;
  const section::LinearStiffness stiffness{.EA = 0, .GJ = 0, .C_AT = 0, .EI = EI};
  return {.law = std::make_shared<section::LinearLaw>("elastic", section::Dimension::planar, stiffness),
          .mass_per_length = keys.messenger->mass_per_length,
          .material = section::material_loss({0, 0, EI, EI}, keys.messenger->loss_factor)};
}

}  // namespace strandyn::build
