#pragma once
/// \file The user's own moment-curvature law: elastic-perfectly-plastic springs side by side on a residual stiffness.
///
///     M = EI chi + sum_i k_i e_i,    e_i = e_i,n + (chi - chi_n), returned to |e_i| <= y_i
///     N = EA eps,    M1 = GJ chi1    (no coupling of the two: C_AT = 0)
/// The virgin curve is multilinear: slope EI + sum of the k_i whose y_i is not reached, one kink per spring. This is
/// what other programs offer, and what lets this one be compared with them. Two forms in space:
///     per axis   each bending axis has its own set of springs, |e_i2| <= y_i and |e_i3| <= y_i
///     coupled    (e_i2, e_i3) is one vector, |e_i| <= y_i, returned along its radius: isotropic
/// Per unit length, exact for a straight step, because a spring's limit never moves:
///     U = 1/2 strain . linear part + sum k e^2/2,    D = sum k e . de_slip >= 0
///     E_quad = sum k/2 (e - e_n) . de_slip >= 0,     delta U + D - E_quad = trapezoidal work
/// (per axis and planar; the radial return is the implicit Euler step of the same law, with the same identity).
///
/// Limits it reproduces: no springs gives EI; no slip gives EI + sum k_i; full slip adds sum k_i y_i to EI chi.
///
/// The springs are marched at every evaluation, stuck or not: eight or so vector instructions for a register of points
/// cost less than finding out.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strandyn/section/law.hpp"

namespace strandyn::section {

struct Spring {
  double stiffness = 0;  ///< [N m^2] moment per curvature; >= 0
  double yield = 0;      ///< [1/m] stretch at which it slips; > 0
};

enum class BendingCoupling { per_axis, coupled };

struct MultilinearSection {
  double EA = 0;  ///< [N]
  double GJ = 0;  ///< [N m^2] spatial only
  double EI = 0;  ///< [N m^2] what is left when every spring slips
  std::vector<Spring> springs;
  BendingCoupling coupling = BendingCoupling::per_axis;  ///< planar: of no effect
};

/// What is wrong with the section, in words, or nothing.
std::optional<std::string> find_fault(const MultilinearSection& section);

class MultilinearLaw final : public Law {
 public:
  MultilinearLaw(MultilinearSection section, Dimension dimension)
      : section_(std::move(section)), dimension_(dimension) {}

  std::string_view name() const override { return "multilinear"; }
  Dimension dimension() const override { return dimension_; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;

 private:
  MultilinearSection section_;
  Dimension dimension_;
};

}  // namespace strandyn::section
