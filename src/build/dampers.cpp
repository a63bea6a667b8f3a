#include "strandyn/build/dampers.hpp"

#include "strandyn/build/section_law.hpp"
#include "strandyn/section/linear_law.hpp"

namespace strandyn::build {

std::vector<damper::HangingArm> arms_of(const casefile::DamperKeys& keys) {
  std::vector<damper::HangingArm> arms;
  for (std::size_t i = 0; i < keys.lengths.size(); ++i) {
    const damper::Weight weight{.mass = keys.masses[i], .inertia = keys.inertias[i], .eccentricity = keys.offsets[i]};
    arms.push_back({.arm = {.length = keys.lengths[i], .weight = weight},
                    .side = (i == 0) != keys.turned ? damper::Side::left : damper::Side::right});
  }
  return arms;
}

damper::Messenger messenger_of(const casefile::DamperKeys& keys) {
  const casefile::MessengerKeys& messenger = *keys.messenger;
  const double mass = *messenger.mass_per_length;
  if (messenger.strand) {
    casefile::Scene scene;
    scene.conductor = messenger.strand;
    scene.section.law = messenger.law;
    scene.section.points = messenger.points;
    const double EI = section_numbers(scene).EI_max;
    return {.law = build_law(scene, section::Dimension::planar),
            .mass_per_length = mass,
            .material = section::material_loss({0, 0, EI, EI}, messenger.loss_factor)};
  }
  const double EI = *messenger.bending_stiffness;
  const section::LinearStiffness stiffness{.EA = 0, .GJ = 0, .C_AT = 0, .EI = EI};
  return {.law = std::make_shared<section::LinearLaw>("elastic", section::Dimension::planar, stiffness),
          .mass_per_length = mass,
          .material = section::material_loss({0, 0, EI, EI}, messenger.loss_factor)};
}

}  // namespace strandyn::build
