#pragma once
/// \file What still air takes from a cylinder that swings across its axis.
///
/// Attached laminar flow, Stokes 1851 and Wang 1968 (J. Fluid Mech. 32, 55), a series in the thickness of the boundary
/// layer over the diameter:
///     beta = D^2 f/nu,   s = (pi beta)^(-1/2)
///     c(f) = 2 pi D sqrt(rho mu omega/2) (1 + s - s^2/4)                              [N s/m^2]
/// which is the drag coefficient 3 pi^3/(2 K) (s + s^2 - s^3/4) at the Keulegan-Carpenter number K = 2 pi A/D. Sarpkaya
/// 1986 (J. Fluid Mech. 165, 61) measured it up to the K at which Honji's vortices make the flow unstable, by Hall 1984
/// (J. Fluid Mech. 146, 347)
///     K_h = 5.778 beta^(-1/4) (1 + 0.205 beta^(-1/4))         1.0 at beta = 1300: A/D 0.16
/// Beyond, the drag is higher. Two parts may stand for that, both off unless asked for:
///     F = rho D C_d/2 |w| w      a drag coefficient, the same at every amplitude (Morison's equation)
///     C_d = a K                  shed vortices of a round body at small K, Graham 1980 (J. Fluid Mech. 97, 331); a =
///     0.2
///                                is quoted for circular cylinders
/// The second is not a force of the moment, since K is that of the swing: in its place stands e |w|^2 w with
/// e = 16 rho a/(9 pi f), which takes the same energy from a sine of frequency f.
///
/// w is the velocity across the axis. The mean power of a sine of velocity amplitude V is
///     c V^2/2 + (4/(3 pi)) q V^3 + (3/8) e V^4,   q = rho D C_d/2
/// so that a loop, V = omega A sin(k x), takes c omega^2 A^2/4 at first order. The mass of air that swings with the
/// conductor, rho pi D^2/4, is left out: some 2e-4 of that of a conductor.

namespace strandyn::air {

struct StillAir {
  double density = 1.204;       ///< [kg/m^3] dry, 20 degrees, at sea level; 0: no air
  double viscosity = 1.5e-5;    ///< [m^2/s] kinematic
  double drag_coefficient = 0;  ///< [-] C_d beside the attached flow
  double drag_per_K = 0;        ///< [-] a of C_d = a K
};

/// Force per length against the velocity w across the axis: (linear + quadratic |w| + cubic w^2) w.
struct AirForce {
  double linear = 0;     ///< [N s/m^2]
  double quadratic = 0;  ///< [N s^2/m^3]
  double cubic = 0;      ///< [N s^3/m^4]

  bool is_none() const { return linear == 0 && quadratic == 0 && cubic == 0; }
  /// [N s/m^2] force over velocity at a speed.
  double factor(double speed) const { return linear + speed * (quadratic + speed * cubic); }
  /// [W/m] mean of a sine of that velocity amplitude [m/s].
  double power_of_sine(double velocity) const;
  /// [W/m] mean over a loop whose antinode has that velocity amplitude [m/s].
  double power_of_loop(double velocity) const;
};

/// c of the attached flow. [N s/m^2] Diameter [m], frequency [Hz] above 0.
double attached_flow(const StillAir& air, double diameter, double frequency);

/// The force on a cylinder that swings at `frequency` [Hz].
AirForce force_at(const StillAir& air, double diameter, double frequency);

/// [-] K_h, beyond which the attached flow is not stable.
double honji_limit(const StillAir& air, double diameter, double frequency);

}  // namespace strandyn::air
