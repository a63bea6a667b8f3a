#pragma once
/// \file What the wires of a committed section do: axial force along the lay, who slips, what the contacts carry.
///
/// Every wire of a layer runs through all swept angles theta, so a profile over theta is the profile along any of its
/// wires over one lay length; a layer-by-angle table of `slips` is the slip map of the section. [FM2016 Figures 6, 18]
///
/// The slip u of a wire is what is missing of the gradient that plane sections ask for, k e - q = k_w u: along a wire
/// it is nearly a first harmonic, whose second derivative is that gradient over EA_w (src/section/README.md,
/// compliant).
///
/// q is constant in a cell of the turn, so F_w is a polygon, handed out in the middle of its sides. That is the exact
/// integral where a layer slips evenly; the first harmonic, which alone makes a moment and is all that a sticking layer
/// has, comes out short by h/tan(h), h = pi/N. With the factor tan(h)/h about the mean, `whole_force`, sums by parts
/// give back to rounding what the law answers at the committed strains, in every state:
///     M2 = EI_min chi2 + sum_j n_j R_j cos(a_j) mean[ sin(theta) F],
///     M3 = EI_min chi3 - sum_j n_j R_j cos(a_j) mean[ cos(theta) F],
///     N  = EA_0 eps + sum_j n_j cos(a_j) mean[F] - N_bending          [FM2016 (25), (27), (28)]
/// (N_bending is part of N where the law was asked to keep it), and a sticking wire has EA_w cos^2(a) y chi.

#include <vector>

namespace strandyn::section {

/// One layer of helical wires, at the midpoints `WireState::theta`.
struct LayerState {
  std::vector<double> force;       ///< [N] F_w of a wire: axial, torsional and bending part
  std::vector<double> gradient;    ///< [N/m] q, the share of dF_w/dS that the history law carries
  std::vector<double> limit;       ///< [N/m] q_lim at the force of the march, the integral of q to the midpoint
  std::vector<bool> slips;         ///< |q| is at its limit (to 1e-9), or the contact is open
  std::vector<double> inner_load;  ///< [N/m of contact helix] f_int of a wire, as its own force sets it there
  std::vector<double> slip;        ///< [m] along itself against plane sections, in the direction of its own demand
  double f_int = 0;                ///< [N/m] layer average, per wire: what is handed to the next layer inward
  double f_ext = 0;                ///< [N/m] average load from the layer outside, per wire of this layer
  double mean_force = 0;           ///< [N] mean of F_w around the turn
  double mean_bending_force = 0;   ///< [N] mean of F_b
};

struct WireState {
  std::vector<double> theta;       ///< [rad] swept angle from axis 2 towards axis 3
  std::vector<LayerState> layers;  ///< `layers[j - 1]` is layer j of the strand; the core has no gradient
  double N_bending = 0;            ///< [N] sum of n cos a mean(F_b): what (35) leaves out of N
  double M1_bending = 0;           ///< [N m] sum of n R sin a mean(F_b); spatial law only

  /// [N] F_w of a layer at an angle with its first harmonic whole.
  double whole_force(const LayerState& layer, std::size_t angle) const;
};

}  // namespace strandyn::section
