#pragma once
/// \file A section law under bending alone: no axial strain reaches it, and it answers with no tension.

#include <algorithm>
#include <memory>

#include "strandyn/section/law.hpp"

namespace strandyn::damper {

/// Planar. A chain that moves across its line stretches as it bends; a messenger, whose end is free to come nearer,
/// does not.
class WithoutAxial final : public section::Law {
 public:
  explicit WithoutAxial(std::shared_ptr<const section::Law> inner) : inner_(std::move(inner)) {}

  std::string_view name() const override { return inner_->name(); }
  section::Dimension dimension() const override { return section::Dimension::planar; }
  section::History start(const section::Field& strains) const override { return inner_->start(bending_of(strains)); }
  section::Effort respond(const section::History& history, const section::Field& strains, section::Field& stresses,
                          section::TangentField* tangents) const override {
    using enum section::Component;
    const section::Effort effort = inner_->respond(history, bending_of(strains), stresses, tangents);
    std::ranges::fill(stresses[axial], 0.0);
    if (tangents) {
      std::ranges::fill((*tangents)(axial, axial), 0.0);
      std::ranges::fill((*tangents)(axial, bending2), 0.0);
      std::ranges::fill((*tangents)(bending2, axial), 0.0);
    }
    return effort;
  }
  section::Effort commit(section::History& history, const section::Field& strains,
                         section::StepEnergy& energy) const override {
    return inner_->commit(history, bending_of(strains), energy);
  }

 private:
  static section::Field bending_of(const section::Field& strains) {
    section::Field bending = strains;
    std::ranges::fill(bending[section::Component::axial], 0.0);
    return bending;
  }

  std::shared_ptr<const section::Law> inner_;
};

}  // namespace strandyn::damper
