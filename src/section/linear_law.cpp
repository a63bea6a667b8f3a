#include "strandyn/section/linear_law.hpp"

#include <algorithm>

namespace strandyn::section {

using enum Component;

History LinearLaw::start(const Field& strains) const {
  return {.points = strains.points(), .data = {}};
}

Effort LinearLaw::respond(const History&, const Field& strains, Field& stresses, TangentField* tangents) const {
  const bool spatial = dimension_ == Dimension::spatial;
  const LinearStiffness& s = stiffness_;
  const auto fill = [tangents](Component row, Component column, double value) {
    AlignedVector& entries = (*tangents)(row, column);
    std::fill(entries.begin(), entries.end(), value);
  };
  for (std::size_t i = 0; i < strains[axial].size(); ++i) {
    stresses[axial][i] = s.EA * strains[axial][i];
    stresses[bending2][i] = s.EI * strains[bending2][i];
  }
  if (tangents) {
    fill(axial, axial, s.EA);
    fill(bending2, bending2, s.EI);
  }
  if (spatial) {
    for (std::size_t i = 0; i < strains[axial].size(); ++i) {
      stresses[axial][i] += s.C_AT * strains[torsion][i];
      stresses[torsion][i] = s.C_AT * strains[axial][i] + s.GJ * strains[torsion][i];
      stresses[bending3][i] = s.EI * strains[bending3][i];
    }
    if (tangents) {
      fill(axial, torsion, s.C_AT);
      fill(torsion, axial, s.C_AT);
      fill(torsion, torsion, s.GJ);
      fill(bending3, bending3, s.EI);
    }
  }
  return {.evaluations = strains.points(), .sweeps = 0};
}

Effort LinearLaw::commit(History&, const Field& strains, StepEnergy& energy) const {
  const LinearStiffness& s = stiffness_;
  for (std::size_t i = 0; i < strains[axial].size(); ++i) {
    const double eps = strains[axial][i];
    const double chi2 = strains[bending2][i];
    energy.stored[i] = 0.5 * (s.EA * eps * eps + s.EI * chi2 * chi2);
    if (dimension_ == Dimension::spatial) {
      const double chi1 = strains[torsion][i];
      const double chi3 = strains[bending3][i];
      energy.stored[i] += 0.5 * (2 * s.C_AT * eps * chi1 + s.GJ * chi1 * chi1 + s.EI * chi3 * chi3);
    }
    energy.dissipated[i] = 0;
    energy.quadrature_error[i] = 0;
  }
  return {.evaluations = strains.points(), .sweeps = 0};
}

}  // namespace strandyn::section
