#include "strandyn/self_damping/protection.hpp"

#include <algorithm>
#include <numbers>

#include "strandyn/build/dampers.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/damper/clamp_stiffness.hpp"

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

const analysis::PointStiffness& Protection::stiffness(std::size_t damper, double frequency) const {
  const auto [at, is_new] = found_[damper].try_emplace(frequency);
  if (!is_new) return at->second;
  const casefile::DamperKeys& keys = dampers_[damper];
  const double omega = 2 * std::numbers::pi * frequency;
  analysis::PointStiffness& sum = at->second;
  sum.force = -omega * omega * *keys.clamp_mass;
  for (const damper::HangingArm& hanging : build::arms_of(keys)) {
    const Eigen::Matrix2cd S = damper::clamp_stiffness(hanging.arm,
                                                       {.EI = *keys.messenger->bending_stiffness,
                                                        .mass_per_length = *keys.messenger->mass_per_length,
                                                        .loss_factor = keys.messenger->loss_factor},
                                                       omega);
    // The end of the span is looked at with its clamp on the left.
    const bool is_at_left = keys.at < length_ / 2;
    const double hand = (hanging.side == damper::Side::right) == is_at_left ? 1 : -1;
    sum.force += S(0, 0);
    sum.coupling += hand * S(0, 1);
    sum.moment += S(1, 1);
  }
  return sum;
}

Protection::Taken Protection::at(const air::Vibration& vibration, double tension) const {
  Taken taken{.largest_end_amplitude = dampers_.size() < 2 ? vibration.antinode_amplitude : 0};
  for (std::size_t i = 0; i < dampers_.size(); ++i) {
    const double distance = std::min(dampers_[i].at, length_ - dampers_[i].at);
    const analysis::EndMotion motion =
        analysis::motion_of({.tension = tension, .mass_per_length = mass_per_length_, .EI = EI_, .distance = distance},
                            stiffness(i, vibration.frequency), vibration.frequency, vibration.antinode_amplitude);
    taken.power += motion.power;
    taken.damper_velocity = std::max(taken.damper_velocity, motion.damper_velocity);
    taken.largest_end_amplitude = std::max(taken.largest_end_amplitude, motion.end_amplitude);
    taken.reflection = std::min(taken.reflection, motion.reflection);
  }
  return taken;
}

}  // namespace strandyn::self_damping
