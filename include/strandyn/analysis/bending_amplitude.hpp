#pragma once
/// \file Bending of a conductor at its clamp: the amplitude that vibration recorders read, and the stress it stands
/// for.
///
///     sigma = K Y_b,   K = d E p^2/4/(exp(-p x) - 1 + p x),   p = sqrt(T/EI_min),   x = 89 mm [PoffenbergerSwart1965]
/// Y_b is the bending amplitude, peak to peak, at the distance x from the last point of contact; sigma is the stress
/// amplitude, half of peak to peak, of a surface wire of diameter d. p is a static shape: it asks for x far shorter
/// than a loop. Y_b of a span that vibrates with the antinode amplitude A, half of peak to peak, is the exact clamped
/// end of a tensioned beam of many loops:
///     y(x) = A/sqrt(1 + (k/q)^2) [sin k x - (k/q) (cos k x - exp(-q x))],   k = pi/loop,   q^2 = k^2 + p^2,   Y_b = 2
///     y
/// Limits: EI_min -> 0: Y_b = 2 A sin(k x), K -> E d p/(4 x); long loop: Y_b = 2 A k [x - (1 - exp(-p x))/p];
/// p x -> 0: K = E d/(2 x^2).

namespace strandyn::analysis {

struct ClampedEnd {
  double tension = 0;       ///< [N]
  double EI_min = 0;        ///< [N m^2] of full slip; above zero
  double distance = 0.089;  ///< [m] x
};
struct SurfaceWire {
  double diameter = 0;  ///< [m] d
  double young = 0;     ///< [Pa] E
};
struct LoopVibration {
  double antinode_amplitude = 0;  ///< [m] A, half of peak to peak
  double loop_length = 0;         ///< [m] half a wavelength of the free span
};

double stress_per_bending_amplitude(const ClampedEnd& end, const SurfaceWire& wire);              ///< K [Pa/m]
double bending_stress(const ClampedEnd& end, const SurfaceWire& wire, double bending_amplitude);  ///< sigma [Pa]
double bending_amplitude(const ClampedEnd& end, const LoopVibration& vibration);  ///< Y_b [m], peak to peak

}  // namespace strandyn::analysis
