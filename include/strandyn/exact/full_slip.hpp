#pragma once
/// \file The bending moment of a strand whose wires all slip, the friction limit following the wire force.
///
/// From the neutral plane (theta = 0, where F_w = F_at) the force of a wire grows towards the tension side and falls
/// towards the compression side by its friction limit,                                       [FM2016 (39), section 7.3]
///     dF_w/dtheta = g(F_w) = R q_lim/|sin a| = max( m F_w + b, g_1 ),   m = mu_int |sin a|,
///     b = R/|sin a| [mu_int (c_ext f_ext + c_int R_res) + mu_ext c_ext f_ext],   g_1 = R/|sin a| mu_ext c_ext f_ext
/// (g_1 where the inner contact is open). While it is closed g = g_0 exp(+-m theta), and the layer gives
///     M = (2/pi) n R cos a g_0 cosh(m pi/2)/(1 + m^2),   mean F_b = (g_0/m) [sinh(m pi/2)/(m pi/2) - 1].
/// The layer average that loads the next contact is F_at + mean F_b: without the second term Curlew's chi_0 comes out
/// 1.2 % low. Twist is held: F_at = EA_w cos^2 a N/EA.
///     chi_0 = M_inf/(EI_max - EI_min),   M_0 = EI_max chi_0
/// Limits: m -> 0 gives the 4/pi EI_c chi_cr of a constant limit; without friction all is zero.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::exact {

struct FullSlip {
  std::vector<double> layer_moment;  ///< [N m] friction part, core first (the core's own is zero)
  double M_inf = 0;                  ///< [N m] their sum
  double chi_0 = 0;                  ///< [1/m] where the full-stick and full-slip lines meet; 0 for a single wire
  double M_0 = 0;                    ///< [N m] there
};

/// Closed form. `tension` [N] of the strand, twist held.
FullSlip full_slip(const conductor::Strand& strand, double tension);

/// The same by the midpoint rule at `points` places around the lay (a multiple of 4, more than pi mu |sin a|), as the
/// return map marches: what it gives at large curvature. 36 points are 0.14 % above the closed form for Curlew.
FullSlip full_slip_at_points(const conductor::Strand& strand, double tension, int points);

}  // namespace strandyn::exact
