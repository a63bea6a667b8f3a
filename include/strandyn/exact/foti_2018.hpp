#pragma once
/// \file Self-damping of a taut conductor in closed form: a simplified loss per section, summed over a sine mode.
///
///     D(chi) = EI chi^3/(2 chi_0)   chi <= chi_0,      EI chi^2/2   beyond         [J/m per cycle]   [FM2018]
///     P = G_1 128 pi^5 m^3 EI y^3 f^7/(chi_0 T^3) + G_2 4 pi^3 m^2 EI y^2 f^5/T^2   [W/m]
///     kn  = asin( min(1, T chi_0/(4 pi^2 m f^2 y)) )/(2 pi)
///     G_1 = 1/3 - (3/8) cos(2 pi kn) + (1/24) cos(6 pi kn),   G_2 = pi - 4 pi kn + sin(4 pi kn)
/// EI is the stiffness of full stick less that of full slip, chi_0 the curvature where the two lines meet. P is the
/// mean over the span of f D(chi), chi = 4 pi^2 m f^2 y/T times the sine.
/// Limits: no section beyond chi_0 (kn = 1/4): P ~ y^3 f^7; all beyond (kn -> 0): P ~ y^2 f^5.
/// Range: chi_0 > 0, tension > 0; bending stiffness left out of the wavenumber.

namespace strandyn::exact {

struct Foti2018 {
  double EI = 0;               ///< [N m^2]
  double chi_0 = 0;            ///< [1/m]
  double mass_per_length = 0;  ///< [kg/m]
  double tension = 0;          ///< [N]
};

/// A sine mode of the taut conductor.
struct SineVibration {
  double antinode_amplitude = 0;  ///< [m] y, half of peak to peak
  double frequency = 0;           ///< [Hz]
};

double loss_per_cycle(const Foti2018& conductor, double curvature_amplitude);    ///< [J/m]
double self_damping(const Foti2018& conductor, const SineVibration& vibration);  ///< [W/m]

}  // namespace strandyn::exact
