#pragma once
/// \file The power that steady vortex shedding puts into a vibrating conductor, from wind tunnels.
///
///     P_w/L = f^3 D^4 fnc(a) B(Iv),   a = A/D,   B = 1/sqrt(1 + (Iv/0.09)^2),   f = St U/D   [W/m]   [EPRI2009]
///     [FM2018]
/// A is the antinode amplitude, half of peak to peak; the length is one of a sine along the span. Iv is the turbulence
/// intensity; B was given with the cubic and is applied to any curve. Each curve has the range of a that it was fitted
/// on; the function itself goes on, wrongly.

#include <array>
#include <span>
#include <string_view>

namespace strandyn::air {

/// A sine vibration of the free span.
struct Vibration {
  double antinode_amplitude = 0;  ///< [m] A
  double frequency = 0;           ///< [Hz]
};

/// A printed row that the polynomial stands for.
struct WindTableRow {
  double a = 0;    ///< [-] A/D
  double fnc = 0;  ///< [W s^3/m^5]
};

struct WindPowerCurve {
  std::string_view name;
  double lowest = 0;                      ///< [-] A/D, where the curve begins
  double highest = 0;                     ///< [-] A/D, where it ends
  std::array<double, 9> coefficients{};   ///< of a^0 ... a^8 [W s^3/m^5]
  std::span<const WindTableRow> table{};  ///< the source's own table, if it has one

  double at(double a) const;  ///< fnc [W s^3/m^5]
};

/// Range 0.01 to 0.85. Off its own table by 11.6 % at most (at 0.03), 8.3 % from 0.06 on.
const WindPowerCurve& diana_falco();
/// Range 0.01 to 0.4. Off its own table by 11.3 % at most (at 0.03), 5.5 % elsewhere.
const WindPowerCurve& brika_laneville();
/// CIGRE's cubic. Range from 0.05 (its constant is a power without motion) to 1.02, where it has fallen to zero; it has
/// no table.
const WindPowerCurve& cigre_cubic();
std::span<const WindPowerCurve* const> wind_power_curves();

double turbulence_factor(double turbulence_intensity);  ///< B [-]; Iv = standard deviation over mean of the speed

struct Wind {
  WindPowerCurve curve;
  double diameter = 0;              ///< [m] of the conductor
  double turbulence_intensity = 0;  ///< [-]
};
double wind_power(const Wind& wind, const Vibration& vibration);  ///< [W/m]

/// Of a cylinder across the wind.
struct VortexShedding {
  double diameter = 0;    ///< [m]
  double strouhal = 0.2;  ///< [-] 0.18 to 0.22 for conductors
};
double shedding_frequency(const VortexShedding& cylinder, double wind_speed);  ///< [Hz]
double wind_speed(const VortexShedding& cylinder, double frequency);           ///< [m/s]

}  // namespace strandyn::air
