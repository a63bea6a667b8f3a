#pragma once
/// \file The strand in planar bending with frozen friction limits: a closed form per layer, Masing's rule, a memory.
///
/// The limit q_lim of each layer is taken at the axial wire force of the state that the law starts from, and stays.
/// Then every angle theta of a layer is an elastic-perfectly-plastic element, and the layer has a closed virgin curve.
/// With c = q_lim/k, k = EA_w cos^2 a |sin a|, h >= 0 the curvature, s = sqrt(h^2 - c^2) (0 while h <= c),
/// phi = acos(c/h) the half angle that slips and beta = pi/2 - phi,
///     V(h) = 2/pi EI_c [c s/h + h beta]                 moment: EI_c h for h <= c, (4/pi) EI_c c as h grows
///     U(h) = 2/pi EI_c [h^2 beta/2 - c s/2 + c^2 phi]   stored,    L(h) = 4/pi EI_c [c s - c^2 phi]   dissipated
/// with U + L the integral of V. From a reversal point r, h = |chi - chi_r|/2 (every element sticks over twice its
/// limit), and with `+-` the sense of the branch
///     M = M_r +- 2 V(h),    U = U_r + (chi - chi_r) M_r + 4 U(h) + 2 L(h),    loss since the reversal = 2 L(h)
/// Memory of a section: the reversal points not yet wiped out. A branch from r_n ends where it meets r_{n-1} (the first
/// one, of the virgin curve, where it meets -r_0): the loop is closed, both points are forgotten and the branch before
/// goes on. That is the memory of the elements themselves, so the law is their exact sum, not an approximation of it.
/// A turn within twice the smallest c of the last reversal (where nothing has slipped) needs no point: same line.
///
/// The stack grows as it must. Only a vibration whose amplitude falls cycle by cycle needs it, two points a cycle as
/// long as it slips, and the next larger amplitude empties it. To forget the smallest loop beyond a fixed depth would
/// make the moment jump where that loop ought to have closed, which no ledger could book: memory is cheaper.
///
/// Energies. `dissipated` and `stored` are those of the straight path of a step, exact, however long the step. The
/// trapezoidal work is not: on a straight path the moment is concave (a turn begins at full stiffness, slip only
/// softens, and where a loop closes the older branch is the softer one), so the chord lies below the curve and
///     E_quad = delta U + D - (M_0 + M_1)/2 delta chi >= 0
/// always: the work of friction that the trapezoid does not see. It is O(h^2) a cycle, it is the return map's E_quad
/// wherever the limits rest, and the identity of law.hpp holds by construction. Where nothing slips it is zero.
///
/// N = EA eps. Axial strain after the start moves no limit: that is the return map's business (return_map.hpp). Against
/// it this law also leaves the wire's own bending force out of its limit.
///
/// Limits it reproduces: mu = 0 gives EI_min and no loss; mu without bound gives EI_max; a symmetric cycle of amplitude
/// x c loses (16/pi) EI_c c^2 [sqrt(x^2 - 1) - acos(1/x)] per layer.

#include <vector>

#include "strandyn/conductor/strand.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::section {

class MasingLaw final : public Law {
 public:
  explicit MasingLaw(conductor::Strand strand);

  std::string_view name() const override { return "masing"; }
  Dimension dimension() const override { return Dimension::planar; }
  /// Freezes the friction limits of each point at its axial strain.
  History start(const Field& strains) const override;
  /// A sweep is a point that slips since its last reversal, so that the closed forms are needed.
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;

  /// The most reversal points that a section of this history remembers.
  std::size_t deepest_memory(const History& history) const;

 private:
  conductor::Strand strand_;
  double EA_ = 0;                   ///< [N]
  double EI_min_ = 0;               ///< [N m^2]
  std::vector<double> EI_layer_;    ///< [N m^2] EI_c of the layers around the core
  std::vector<double> k_of_layer_;  ///< [N m] gradient of the wire force per curvature
};

}  // namespace strandyn::section
