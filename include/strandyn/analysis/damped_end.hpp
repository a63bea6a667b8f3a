#pragma once
/// \file The end of a long span with a damper near its clamp: how hard a wave shakes the damper, and what that takes.
///
/// A clamped beam of tension T, bending stiffness EI and mass m per length, with a damper at x = d whose clamp moves
/// and turns with it: (F, M) = S (y, y'), S its dynamic stiffness, i omega times its impedance. At the frequency omega
///     k^2 = (-T + sqrt(T^2 + 4 EI m omega^2))/(2 EI),   q^2 = k^2 + T/EI
///     x < d:   y = A_1 sin(k x) + A_2 cos(k x) + A_3 exp(-q x) + A_4 exp(q (x - d)),   y = y' = 0 at x = 0
///     x > d:   y = a exp(i k (x - d)) + b exp(-i k (x - d)) + g exp(-q (x - d))
/// y and y' are continuous at d, EI (y'''(d-) - y'''(d+)) = F, EI (y''(d+) - y''(d-)) = M. The antinodes of the span
/// have the amplitude A = |a| + |b|. The damper takes
///     P = omega Im[(y, y')* S (y, y')]/2 = (T + 2 EI k^2) k omega (|a|^2 - |b|^2)/2
/// Limits: EI = 0 is the string, y = A_1 sin(k x) between clamp and damper, which bears no moment; there F/(i omega y)
/// = sqrt(T m) at a quarter of a wave takes all that comes, and no wave goes back. A stiff end holds the wave off by
/// sqrt(EI/T): a damper near it moves less.

#include <complex>

namespace strandyn::analysis {

struct DampedEnd {
  double tension = 0;          ///< [N]
  double mass_per_length = 0;  ///< [kg/m]
  double EI = 0;               ///< [N m^2]
  double distance = 0;         ///< [m] of the damper from the clamp
};

/// S, which is symmetric.
struct PointStiffness {
  std::complex<double> force;     ///< [N/m]
  std::complex<double> coupling;  ///< [N] force by rotation, moment by displacement
  std::complex<double> moment;    ///< [N m]
};

struct EndMotion {
  double damper_velocity = 0;  ///< [m/s] amplitude at the damper
  double power = 0;            ///< [W] that it takes
  double end_amplitude = 0;    ///< [m] amplitude of the sine between clamp and damper
  double reflection = 1;       ///< [-] amplitude of the wave that goes back over that of the one that comes
};

/// Where the antinodes of the span have the amplitude `antinode_amplitude` [m], half of peak to peak.
EndMotion motion_of(const DampedEnd& end, const PointStiffness& damper, double frequency, double antinode_amplitude);

}  // namespace strandyn::analysis
