#include "strandyn/section/stiffened_law.hpp"

#include <numbers>

namespace strandyn::section {

using enum Component;

Effort StiffenedLaw::respond(const History& history, const Field& strains, Field& stresses,
                             TangentField* tangents) const {
  const Effort effort = strand_->respond(history, strains, stresses, tangents);
  for (const Component c : {bending2, bending3}) {
    if (!carries(dimension(), c)) continue;
    for (std::size_t i = 0; i < strains.points(); ++i) {
      stresses[c][i] += EI_ * strains[c][i];
      if (tangents) (*tangents)(c, c)[i] += EI_;
    }
  }
  return effort;
}

Effort StiffenedLaw::commit(History& history, const Field& strains, StepEnergy& energy) const {
  const Effort effort = strand_->commit(history, strains, energy);
  for (const Component c : {bending2, bending3}) {
    if (!carries(dimension(), c)) continue;
    for (std::size_t i = 0; i < strains.points(); ++i) {
      energy.stored[i] += 0.5 * EI_ * strains[c][i] * strains[c][i];
    }
  }
  return effort;
}

double ArmourRods::loose_stiffness() const {
  const double d2 = diameter * diameter;
  return rods * young * std::numbers::pi * d2 * d2 / 64;
}

double ArmourRods::area() const {
  return rods * std::numbers::pi * diameter * diameter / 4;
}

double ArmourRods::bonded_stiffness(double strand_diameter) const {
  const double radius = (strand_diameter + diameter) / 2;
  return loose_stiffness() + young * area() * radius * radius / 2;
}

}  // namespace strandyn::section
