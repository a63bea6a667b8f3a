#pragma once
/// \file A strand with something elastic around it that bends with it: armour rods.
///
///     M = M_law + EI chi,    U = U_law + 1/2 EI chi^2
/// in both planes. What is around carries no tension and no torsion: it was put on after the strand was strung, and
/// grips it over its length only. Friction between the two is left out.

#include <memory>

#include "strandyn/section/law.hpp"

namespace strandyn::section {

class StiffenedLaw final : public Law {
 public:
  /// `EI` [N m^2] >= 0.
  StiffenedLaw(std::shared_ptr<const Law> strand, double EI) : strand_(std::move(strand)), EI_(EI) {}

  std::string_view name() const override { return strand_->name(); }
  Dimension dimension() const override { return strand_->dimension(); }
  History start(const Field& strains) const override { return strand_->start(strains); }
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;
  WireState wires(const History& history, const Field& committed_strains, std::size_t point) const override {
    return strand_->wires(history, committed_strains, point);
  }

 private:
  std::shared_ptr<const Law> strand_;
  double EI_;
};

/// [N m^2] of `rods` round rods of a diameter [m] and a modulus [Pa] around a strand of a diameter [m]. Loose: each
/// bends about its own axis. Bonded: all keep one plane section, as one tube with the strand inside it, too.
struct ArmourRods {
  int rods = 0;
  double diameter = 0;
  double young = 0;

  double area() const;  ///< [m^2] of all rods
  double loose_stiffness() const;
  double bonded_stiffness(double strand_diameter) const;
};

}  // namespace strandyn::section
