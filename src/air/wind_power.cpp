#include "strandyn/air/wind_power.hpp"

#include <cmath>

namespace strandyn::air {
namespace {

constexpr WindTableRow diana_falco_table[] = {{0.03, 0.23}, {0.06, 0.70}, {0.1, 1.8}, {0.2, 5.0}, {0.3, 9.0},
                                              {0.4, 14},    {0.5, 18},    {0.6, 20},  {0.7, 21},  {0.8, 20}};
constexpr WindTableRow brika_laneville_table[] = {{0.01, 0.03}, {0.03, 0.17}, {0.06, 0.49}, {0.1, 1.1},
                                                  {0.2, 3.2},   {0.3, 5.5},   {0.4, 6.0}};

constexpr WindPowerCurve diana_falco_curve{
    .name = "Diana & Falco",
    .lowest = 0.01,
    .highest = 0.85,
    .coefficients = {0, 3.12858, 208.972, -1048.68829, 3894.56424, -8396.67235, 9919.9573, -6137.30905, 1573.9704},
    .table = diana_falco_table};
// The seventh coefficient (of a^7) is negative: with the other sign the curve leaves its own table from 0.2 on.
constexpr WindPowerCurve brika_laneville_curve{
    .name = "Brika & Laneville",
    .lowest = 0.01,
    .highest = 0.4,
    .coefficients = {0, 1.79838, 118.93429, -432.36754, 2188.63016, -11857.16738, 39612.62833, -68607.57765, 45073.019},
    .table = brika_laneville_table};
constexpr WindPowerCurve cigre_cubic_curve{
    .name = "CIGRE cubic", .lowest = 0.05, .highest = 1.02, .coefficients = {0.2256, 0.1627, 101.62, -99.73}};

constexpr const WindPowerCurve* curves[] = {&diana_falco_curve, &brika_laneville_curve, &cigre_cubic_curve};

}  // namespace

double WindPowerCurve::at(double a) const {
  double sum = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * a + coefficients[i];
  return sum;
}

const WindPowerCurve& diana_falco() {
  return diana_falco_curve;
}
const WindPowerCurve& brika_laneville() {
  return brika_laneville_curve;
}
const WindPowerCurve& cigre_cubic() {
  return cigre_cubic_curve;
}
std::span<const WindPowerCurve* const> wind_power_curves() {
  return curves;
}

double turbulence_factor(double turbulence_intensity) {
  constexpr double reference = 0.09;
  return 1 / std::hypot(1.0, turbulence_intensity / reference);
}

double wind_power(const Wind& wind, const Vibration& vibration) {
  const double D = wind.diameter;
  const double f = vibration.frequency;
  return f * f * f * D * D * D * D * wind.curve.at(vibration.antinode_amplitude / D) *
         turbulence_factor(wind.turbulence_intensity);
}

double shedding_frequency(const VortexShedding& cylinder, double wind_speed) {
  return cylinder.strouhal * wind_speed / cylinder.diameter;
}

double wind_speed(const VortexShedding& cylinder, double frequency) {
  return frequency * cylinder.diameter / cylinder.strouhal;
}

}  // namespace strandyn::air
