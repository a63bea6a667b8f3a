#pragma once
/// \file The linear rungs: `stick` (EI_max), `slip` (EI_min) and `elastic` (given constants). No history, no loss.
///
///     (N, M1) = [EA, C_AT; C_AT, GJ] (eps, chi1),    (M2, M3) = EI (chi2, chi3),    U = 1/2 strain . resultant

#include "strandyn/section/law.hpp"

namespace strandyn::section {

struct LinearStiffness {
  double EA = 0;    ///< [N]
  double GJ = 0;    ///< [N m^2]
  double C_AT = 0;  ///< [N m]
  double EI = 0;    ///< [N m^2]
};

class LinearLaw final : public Law {
 public:
  LinearLaw(std::string_view name, Dimension dimension, LinearStiffness stiffness)
      : name_(name), dimension_(dimension), stiffness_(stiffness) {}

  std::string_view name() const override { return name_; }
  Dimension dimension() const override { return dimension_; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;

 private:
  std::string_view name_;
  Dimension dimension_;
  LinearStiffness stiffness_;
};

}  // namespace strandyn::section
