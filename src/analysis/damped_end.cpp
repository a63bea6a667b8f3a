#include "strandyn/analysis/damped_end.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::analysis {
namespace {

using Complex = std::complex<double>;
constexpr Complex i(0, 1);

/// The motion at any scale.
struct Shape {
  Complex at_damper;    // y(d)
  Complex back, forth;  // a, b
  double end = 0;       // amplitude of the sine between clamp and damper
};

Shape of_string(const DampedEnd& end, Complex Z, double omega) {
  const double k = omega * std::sqrt(end.mass_per_length / end.tension);
  const double s = std::sin(k * end.distance);
  const Complex slope = k * std::cos(k * end.distance) + i * omega * Z * s / end.tension;
  return {.at_damper = s, .back = (s + slope / (i * k)) / 2.0, .forth = (s - slope / (i * k)) / 2.0, .end = 1};
}

Shape of_beam(const DampedEnd& end, Complex Z, double omega) {
  const double T = end.tension, EI = end.EI, d = end.distance, m = end.mass_per_length;
  // Without the difference of large numbers where EI is small.
  const double k2 = 2 * m * omega * omega / (T + std::sqrt(T * T + 4 * EI * m * omega * omega));
  const double k = std::sqrt(k2), q = std::sqrt(k2 + T / EI);
  const double s = std::sin(k * d), c = std::cos(k * d), e = std::exp(-q * d);
  const Complex force = i * omega * Z / EI, k3 = i * (k2 * k);
  const double q2 = q * q, q3 = q2 * q;
  // Of A_1 ... A_4, a, b, g: the clamp, then y, y', y''/q^2 and y'''/q^3 at d, and the scale A_1 = 1.
  Eigen::Matrix<Complex, 7, 7> M;
  M << 0, 1, 1, e, 0, 0, 0,                                                                               //
      k / q, 0, -1, e, 0, 0, 0,                                                                           //
      s, c, e, 1, -1, -1, -1,                                                                             //
      k / q * c, -k / q * s, -e, 1, -i * k / q, i * k / q, 1,                                             //
      -k2 / q2 * s, -k2 / q2 * c, e, 1, k2 / q2, k2 / q2, -1,                                             //
      -k2 * k / q3 * c, k2 * k / q3 * s, -e, 1, (k3 - force) / q3, (-k3 - force) / q3, 1.0 - force / q3,  //
      1, 0, 0, 0, 0, 0, 0;
  Eigen::Matrix<Complex, 7, 1> right = Eigen::Matrix<Complex, 7, 1>::Zero();
  right(6) = 1;
  const Eigen::Matrix<Complex, 7, 1> x = M.fullPivLu().solve(right);
  return {
      .at_damper = x(4) + x(5) + x(6), .back = x(4), .forth = x(5), .end = std::hypot(std::abs(x(0)), std::abs(x(1)))};
}

}  // namespace

EndMotion motion_of(const DampedEnd& end, std::complex<double> impedance, double frequency, double antinode_amplitude) {
  const double omega = 2 * std::numbers::pi * frequency;
  const Shape shape = end.EI > 0 ? of_beam(end, impedance, omega) : of_string(end, impedance, omega);
  const double a = std::abs(shape.back), b = std::abs(shape.forth);
  const double scale = antinode_amplitude / (a + b);
  const double velocity = omega * scale * std::abs(shape.at_damper);
  // With Re Z > 0 the larger one is the wave that comes.
  return {.damper_velocity = velocity,
          .power = impedance.real() * velocity * velocity / 2,
          .end_amplitude = scale * shape.end,
          .reflection = std::min(a, b) / std::max(a, b)};
}

}  // namespace strandyn::analysis
