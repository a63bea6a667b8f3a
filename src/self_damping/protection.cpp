#include "strandyn/self_damping/protection.hpp"

#include <algorithm>
#include <numbers>

#include "strandyn/build/dampers.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/damper/reduced_arm.hpp"

namespace strandyn::self_damping {

Protection::Protection(const casefile::Scene& scene, const casefile::EnergyBalanceKeys& keys,
                       std::optional<double> first_at)
    : dampers_(keys.dampers),
      length_(keys.span.value_or(0)),
      mass_per_length_(*casefile::mass_per_length(scene)),
      EI_(build::section_numbers(scene).EI_max),
      found_(dampers_.size()) {
  if (first_at && !dampers_.empty()) dampers_.front().at = *first_at;
}

std::complex<double> Protection::impedance(std::size_t damper, double frequency) const {
  const auto [at, is_new] = found_[damper].try_emplace(frequency);
  if (!is_new) return at->second;
  const casefile::DamperKeys& keys = dampers_[damper];
  const damper::Messenger messenger = build::messenger_of(keys);
  const damper::BendingLoops loops(*messenger.law, {.per_decade = 2, .samples = 16, .cycles = 1});
  std::complex<double> Z(0, 2 * std::numbers::pi * frequency * *keys.clamp_mass);
  for (const damper::HangingArm& hanging : build::arms_of(keys)) {
    damper::ReducedArm arm(hanging.arm, messenger, loops);
    Z += arm.answer({.frequency = frequency, .velocity = 0.1}).impedance();
  }
  return at->second = Z;
}

Protection::Taken Protection::at(const air::Vibration& vibration, double tension) const {
  Taken taken{.largest_end_amplitude = dampers_.size() < 2 ? vibration.antinode_amplitude : 0};
  for (std::size_t i = 0; i < dampers_.size(); ++i) {
    const double distance = std::min(dampers_[i].at, length_ - dampers_[i].at);
    const analysis::EndMotion motion =
        analysis::motion_of({.tension = tension, .mass_per_length = mass_per_length_, .EI = EI_, .distance = distance},
                            impedance(i, vibration.frequency), vibration.frequency, vibration.antinode_amplitude);
    taken.power += motion.power;
    taken.damper_velocity = std::max(taken.damper_velocity, motion.damper_velocity);
    taken.largest_end_amplitude = std::max(taken.largest_end_amplitude, motion.end_amplitude);
    taken.reflection = std::min(taken.reflection, motion.reflection);
  }
  return taken;
}

}  // namespace strandyn::self_damping
