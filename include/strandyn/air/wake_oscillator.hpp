#pragma once
/// \file The wake of a cylinder in the wind as an oscillator, after Facchinetti, de Langre and Biolley 2004 (J. Fluids
/// and Structures 19, 123), coupled by the acceleration of the cylinder.
///
///     omega_f = 2 pi St U/D
///     q'' + epsilon omega_f (q^2 - 1) q' + omega_f^2 q = (A/D) y''                              van der Pol
///     F = (rho U^2 D/4) C_L0 q - gamma omega_f rho D^2 y'                              [N/m] across the wind
/// q is twice the lift coefficient over that of a cylinder at rest, C_L0. The second part of F is the fluid's own
/// damping; gamma = C_D/(4 pi St). The mass of air that moves along, m_a = C_M rho pi D^2/4, belongs to the inertia.
///
/// Of the cylinder at rest q swings with the amplitude 2 and the frequency omega_f (1 - epsilon^2/16), to the next
/// order: 2 (1 + epsilon^2/96) in its fundamental.
///
/// Over a step the acceleration is linear in time; the equation goes by substeps of the classical Runge-Kutta method,
/// at least 40 a period. A function of the state at its beginning and of the acceleration at its end: a trial may be
/// thrown away.

namespace strandyn::air {

struct WakeModel {
  double strouhal = 0.2;   ///< [-]
  double epsilon = 0.3;    ///< [-]
  double coupling = 12;    ///< [-] A
  double lift = 0.3;       ///< [-] C_L0
  double stall = 0.8;      ///< [-] gamma
  double density = 1.204;  ///< [kg/m^3]
  double diameter = 0;     ///< [m]
  double added_mass = 1;   ///< [-] C_M

  double angular_frequency(double speed) const;  ///< [rad/s] omega_f, at a wind speed [m/s]
  double lift_per_q(double speed) const;         ///< [N/m] force on a metre at q = 1
  double damping(double speed) const;            ///< [N s/m^2] of the fluid
  double mass_of_air() const;                    ///< [kg/m] m_a
};

struct Wake {
  double q = 0;     ///< [-]
  double rate = 0;  ///< [1/s]
};

/// The acceleration of the cylinder [m/s^2] at the ends of a step.
struct StepOfCylinder {
  double length = 0;  ///< [s]
  double from = 0, to = 0;
};

/// The wake at the end of the step.
Wake advance(const WakeModel& model, double speed, Wake wake, const StepOfCylinder& step);

}  // namespace strandyn::air
