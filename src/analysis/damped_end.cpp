#include "strandyn/analysis/damped_end.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace strandyn::analysis {
namespace {

using Complex = std::complex<double>;
constexpr Complex i(0, 1);

/// The motion at any scale.
struct Shape {
  Complex at_damper;    // y(d)
  Complex turn;         // y'(d)
  Complex back, forth;  // a, b
  double end = 0;       // amplitude of the sine between clamp and damper
};

Shape of_string(const DampedEnd& end, const PointStiffness& S, double omega) {
  const double k = omega * std::sqrt(end.mass_per_length / end.tension);
  const double s = std::sin(k * end.distance);
  const Complex slope = k * std::cos(k * end.distance) + S.force * s / end.tension;
  return {
      .at_damper = s, .turn = 0, .back = (s + slope / (i * k)) / 2.0, .forth = (s - slope / (i * k)) / 2.0, .end = 1};
}

Shape of_beam(const DampedEnd& end, const PointStiffness& S, double omega) {
  const double T = end.tension, EI = end.EI, d = end.distance, m = end.mass_per_length;
  // Without the difference of large numbers where EI is small.
  const double k2 = 2 * m * omega * omega / (T + std::sqrt(T * T + 4 * EI * m * omega * omega));
  const double k = std::sqrt(k2), q = std::sqrt(k2 + T / EI);
  const double s = std::sin(k * d), c = std::cos(k * d), e = std::exp(-q * d);
  const double q2 = q * q, q3 = q2 * q;
  // Of A_1 ... A_4, a, b, g: values and derivatives at d, to the left and to the right.
  using Row = Eigen::Matrix<Complex, 1, 7>;
  const auto row = [](std::array<Complex, 7> x) { return Row(x.data()); };
  const Complex ik = i * k;
  const Row y = row({0, 0, 0, 0, 1, 1, 1});
  const Row slope = row({0, 0, 0, 0, ik, -ik, -q});
  Eigen::Matrix<Complex, 7, 7> M;
  M.row(0) = row({0, 1, 1, e, 0, 0, 0});
  M.row(1) = row({k / q, 0, -1, e, 0, 0, 0});
  M.row(2) = row({s, c, e, 1, -1, -1, -1});
  M.row(3) = row({k * c, -k * s, -q * e, q, -ik, ik, q}) / q;
  M.row(4) = (row({-k2 * s, -k2 * c, q2 * e, q2, k2, k2, -q2}) + (S.coupling * y + S.moment * slope) / EI) / q2;
  M.row(5) =
      (row({-k2 * k * c, k2 * k * s, -q3 * e, q3, ik * k2, -ik * k2, q3}) - (S.force * y + S.coupling * slope) / EI) /
      q3;
  M.row(6) = row({1, 0, 0, 0, 0, 0, 0});  // of any scale
  Eigen::Matrix<Complex, 7, 1> right = Eigen::Matrix<Complex, 7, 1>::Zero();
  right(6) = 1;
  const Eigen::Matrix<Complex, 7, 1> x = M.fullPivLu().solve(right);
  return {.at_damper = x(4) + x(5) + x(6),
          .turn = (slope * x)(0),
          .back = x(4),
          .forth = x(5),
          .end = std::hypot(std::abs(x(0)), std::abs(x(1)))};
}

}  // namespace

EndMotion motion_of(const DampedEnd& end, const PointStiffness& damper, double frequency, double antinode_amplitude) {
  const double omega = 2 * std::numbers::pi * frequency;
  const Shape shape = end.EI > 0 ? of_beam(end, damper, omega) : of_string(end, damper, omega);
  const double a = std::abs(shape.back), b = std::abs(shape.forth);
  const double scale = antinode_amplitude / (a + b);
  const Complex y = scale * shape.at_damper, turn = scale * shape.turn;
  const Complex work = std::conj(y) * (damper.force * y + damper.coupling * turn) +
                       std::conj(turn) * (damper.coupling * y + damper.moment * turn);
  // With a damper that takes energy the larger one is the wave that comes.
  return {.damper_velocity = omega * std::abs(y),
          .power = omega * work.imag() / 2,
          .end_amplitude = scale * shape.end,
          .reflection = std::min(a, b) / std::max(a, b)};
}

}  // namespace strandyn::analysis
