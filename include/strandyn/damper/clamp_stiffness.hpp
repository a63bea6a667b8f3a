#pragma once
/// \file What an elastic arm asks of a clamp that moves and turns as a sine: its dynamic stiffness.
///
/// One cubic element of the messenger, EI* = EI (1 + i eta), with its consistent mass and the weight beside its end;
/// the unknowns at the weight are condensed:
///     (F, M) = S (y, theta),   S = D_cc - D_cw D_ww^-1 D_wc,   D = K* - omega^2 M
/// F exp(i omega t) and M exp(i omega t) move the clamp by y and turn it by theta. Without rotation F is that of
/// reduced_arm.hpp. One element is within 1e-4 of the exact beam's resonances.

#include <Eigen/Dense>

#include "strandyn/damper/damper.hpp"

namespace strandyn::damper {

struct ElasticMessenger {
  double EI = 0;               ///< [N m^2]
  double mass_per_length = 0;  ///< [kg/m]
  double loss_factor = 0;      ///< [-]
};

/// [N/m], [N], [N m] of an arm to the right of its clamp, at omega [rad/s].
Eigen::Matrix2cd clamp_stiffness(const Arm& arm, const ElasticMessenger& messenger, double omega);

}  // namespace strandyn::damper
