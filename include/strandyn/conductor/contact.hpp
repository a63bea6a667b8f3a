#pragma once
/// \file Contact forces between the layers and the friction limit that they set.
///
/// Radial equilibrium of a wire, residual force on its inner contact helix:
///     c_int f_int = kappa F_w + c_ext f_ext + c_int R_res,     c_int,ext = 1 -+ kappa d/2              [FM2016 (38b)]
/// handed inward by n_j f_int_j = n_{j-1} f_ext_{j-1}, f_ext of the outermost layer zero (42). Coulomb on both contact
/// helices bounds the gradient of the wire force:
///     |dF_w/dS| <= q_lim = mu_int c_int f_int(F_w) + mu_ext c_ext f_ext                                    (39)
/// A contact cannot pull: f_int, f_ext, q_lim >= 0. The paper's (45b) counts the outer layers' residual forces twice;
/// radial equilibrium has them once.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::conductor {

/// What the friction limit of one layer needs, per wire; constant for a given strand.
struct ContactGeometry {
  double sin_lay = 0;  ///< |sin(alpha)|, kept above 1e-9 so that a straight wire is the limit of a helical one
  double cos_lay = 1;
  double kappa = 0;             ///< [1/m] curvature of the wire's centre line
  double c_int = 1;             ///< [-] length of the inner contact helix over the centre line's
  double c_ext = 1;             ///< [-] the same for the outer one
  double mu_int = 0;            ///< [-]
  double mu_ext = 0;            ///< [-] friction_inner of the next layer, 0 for the outermost
  double residual = 0;          ///< [N/m] R_res
  double next_layer_ratio = 0;  ///< n_{j+1}/n_j, 0 for the outermost: f_ext_j = this * f_int_{j+1}
};

/// One entry per layer, core first (the core's own entry only closes the numbering).
std::vector<ContactGeometry> contact_geometry(const Strand& strand);

/// Line loads of one layer, per wire. [N/m of contact helix]
struct ContactForces {
  double f_int = 0;
  double f_ext = 0;
  double q_lim = 0;  ///< [N/m] friction limit of the wire's force gradient
};

/// March from the outermost layer inward. `wire_force[j]` [N]: layer-average axial force of a wire, core first.
std::vector<ContactForces> contact_forces(const Strand& strand, const std::vector<double>& wire_force);

/// [N] axial force of a wire of each layer, core first, under axial strain `eps` [-] and twist `chi1` [rad/m]: (15).
std::vector<double> axial_wire_forces(const Strand& strand, double eps, double chi1);

}  // namespace strandyn::conductor
