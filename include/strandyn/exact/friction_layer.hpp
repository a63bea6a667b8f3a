#pragma once
/// \file A layer whose friction limit is constant: every polar angle is an elastic-perfectly-plastic element.
///
/// With chi_cr = q_lim/k, k = EA_w cos^2 a |sin a|, EI_c = n/2 cos^3 a EA_w R^2 and x = chi/chi_cr   [FM2016, sections
/// 6, 7]
///     virgin curve    M = EI_c chi                                                        x <= 1
///                     M = (2/pi) EI_c chi_cr [sqrt(1 - 1/x^2) + x asin(1/x)]              x >= 1
///     reversal        M = M_r + 2 M_virgin((chi - chi_r)/2)                               [Masing1926]
///     loss per cycle  D = (16/pi) EI_c chi_cr^2 [sqrt(x^2 - 1) - acos(1/x)]               x > 1, else 0
///     circular orbit  D = 8 EI_c chi_cr (chi - chi_cr)                                    x > 1, else 0
/// The orbit is a curvature of constant size that turns once; every angle then sees the same cycle.
/// Limits: M -> (4/pi) EI_c chi_cr; D -> 4 chi M_inf of a rigid-plastic loop; chi_cr = 0: nothing but EI_min is left.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::exact {

struct FrictionLayer {
  double EI_c = 0;    ///< [N m^2] what the sticking layer adds to EI_min
  double chi_cr = 0;  ///< [1/m] curvature of first slip
};

/// A point of a moment-curvature curve.
struct MomentCurvature {
  double chi = 0;  ///< [1/m]
  double M = 0;    ///< [N m]
};

double virgin_moment(const FrictionLayer& layer, double chi);   ///< [N m] odd in chi
double virgin_tangent(const FrictionLayer& layer, double chi);  ///< [N m^2]
double limit_moment(const FrictionLayer& layer);                ///< [N m]

/// [N m] on the branch that left `reversal`, until it closes the cycle or meets the virgin curve.
double masing_moment(const FrictionLayer& layer, const MomentCurvature& reversal, double chi);

double loss_per_cycle(const FrictionLayer& layer, double amplitude);  ///< [J/m] symmetric cycles of planar bending
double loss_per_orbit(const FrictionLayer& layer, double amplitude);  ///< [J/m] after the first turn

/// The layers of a strand under wire forces [N] (core first) that bending leaves unchanged; the core is left out.
std::vector<FrictionLayer> friction_layers(const conductor::Strand& strand, const std::vector<double>& wire_force);

}  // namespace strandyn::exact
