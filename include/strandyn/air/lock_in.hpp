#pragma once
/// \file A rigid cylinder on springs and its wake, both as one sine each: where they can swing together.
///
///     m (y'' + 2 zeta omega y' + omega^2 y) = L q - d y',    q'' + epsilon omega_f (q^2 - 1) q' + omega_f^2 q = (A/D)
///     y''
/// with y = Re(Y e^{i W t}), q = q_0 cos(W t), and of q^2 q' the fundamental alone, (q_0^2/4) q':
///     Y = q_0 G(W),    G = L/(m omega^2 - m W^2 + i W (2 m zeta omega + d))
///     omega_f^2 - W^2 = -(A/D) W^2 Re G                       the frequency: a cubic in W^2, one root or three
///     q_0^2 = 4 (1 - (A/D) W Im G/(epsilon omega_f))          the amplitude, where it is real
/// after Facchinetti, de Langre and Biolley 2004. What the third harmonic of q adds is left out: some parts of
/// epsilon^2. Which of several branches a wind that rises or falls follows is not said here.

#include <vector>

#include "strandyn/air/wake_oscillator.hpp"

namespace strandyn::air {

/// A metre of it.
struct CylinderOnSprings {
  double mass = 0;           ///< [kg/m] the air that moves along in it
  double frequency = 0;      ///< [Hz] without wind
  double damping_ratio = 0;  ///< [-]
};

struct LockedIn {
  double frequency = 0;       ///< [Hz]
  double amplitude = 0;       ///< [m]
  double wake_amplitude = 0;  ///< [-] of q
};

/// All of them, by frequency; of a wind speed [m/s] > 0.
std::vector<LockedIn> lock_in(const WakeModel& wake, const CylinderOnSprings& cylinder, double speed);

}  // namespace strandyn::air
