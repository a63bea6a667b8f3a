#include "strandyn/math/rotation.hpp"

#include <cmath>
#include <numbers>

#include "strandyn/math/stumpff.hpp"

namespace strandyn::math {
namespace {

/// 1 + b S + c S^2.
Eigen::Matrix3d polynomial(const Eigen::Vector3d& psi, double b, double c) {
  const double x = psi.x();
  const double y = psi.y();
  const double z = psi.z();
  Eigen::Matrix3d m;
  m << 1 - c * (y * y + z * z), c * x * y - b * z, c * x * z + b * y,  //
      c * x * y + b * z, 1 - c * (x * x + z * z), c * y * z - b * x,   //
      c * x * z - b * y, c * y * z + b * x, 1 - c * (x * x + y * y);
  return m;
}

/// A coefficient, and its derivative by |psi|^2.
struct Coefficient {
  double value = 0, slope = 0;
};

Coefficient coefficient(const Stumpff& c, std::size_t k) {
  return {.value = c[k], .slope = stumpff_derivative(c, k)};
}

/// That of S^2 in T^-1: e = -c_2'/c_2.
Coefficient inverse_coefficient(const Stumpff& c) {
  const double e = -stumpff_derivative(c, 2) / c[2];
  return {.value = e, .slope = -stumpff_second_derivative(c, 2) / c[2] + e * e};
}

/// Derivative by psi of m + b psi x m + c psi x (psi x m).
Eigen::Matrix3d slope(const Eigen::Vector3d& psi, const Eigen::Vector3d& m, Coefficient b, Coefficient c) {
  const Eigen::Vector3d once = psi.cross(m);
  const Eigen::Vector3d grows = 2 * (b.slope * once + c.slope * psi.cross(once) - c.value * m);
  Eigen::Matrix3d out = grows * psi.transpose() + c.value * psi * m.transpose() - b.value * skew(m);
  out.diagonal().array() += c.value * psi.dot(m);
  return out;
}

}  // namespace

Eigen::Matrix3d rotation(const Eigen::Vector3d& psi) {
  const Stumpff c = stumpff(psi.squaredNorm());
  return polynomial(psi, c[1], c[2]);
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);  // from the largest of its four components: good at all angles
  const double squared = q.vec().squaredNorm();
  const double sign = q.w() < 0 ? -1 : 1;
  if (squared < 1e-16) return 2 * sign * q.vec();  // atan2(s, w)/s = 1 + s^2/6
  const double sine = std::sqrt(squared);
  return sign * 2 * std::atan2(sine, std::abs(q.w())) / sine * q.vec();
}

Eigen::Matrix3d spin_map(const Eigen::Vector3d& psi) {
  const Stumpff c = stumpff(psi.squaredNorm());
  return polynomial(psi, c[2], c[3]);
}

Eigen::Matrix3d inverse_spin_map(const Eigen::Vector3d& psi) {
  return polynomial(psi, -0.5, inverse_coefficient(stumpff(psi.squaredNorm())).value);
}

Eigen::Matrix3d spin_map_transposed_slope(const Eigen::Vector3d& psi, const Eigen::Vector3d& m) {
  const Stumpff c = stumpff(psi.squaredNorm());
  const Coefficient spin = coefficient(c, 2);
  return slope(psi, m, {.value = -spin.value, .slope = -spin.slope}, coefficient(c, 3));
}

Eigen::Matrix3d inverse_spin_map_transposed_slope(const Eigen::Vector3d& psi, const Eigen::Vector3d& m) {
  return slope(psi, m, {.value = 0.5}, inverse_coefficient(stumpff(psi.squaredNorm())));
}

RotationState shortened(const RotationState& state) {
  const double angle = state.psi.norm();
  if (angle <= std::numbers::pi) return state;
  const Eigen::Vector3d axis = state.psi / angle;
  const double rest = std::remainder(angle, 2 * std::numbers::pi);
  // (rest/angle) psi, differentiated while the number of turns stays: the spin is the same because the rotation is.
  const Eigen::Vector3d along = axis.dot(state.rate) * axis;
  return {.psi = rest * axis, .rate = along + rest / angle * (state.rate - along)};
}

}  // namespace strandyn::math
