#pragma once
/// \file Finite rotations in space, written with the rotation vector psi: axis times angle, any number of turns.
///
///     R(psi) = exp(S) = 1 + c_1 S + c_2 S^2,                      S = skew(psi)
///     dR = skew(w) R  with the spatial spin  w = T(psi) dpsi,     T = 1 + c_2 S + c_3 S^2
///     T^-1 = 1 - S/2 + e S^2,                                     e = -c_2'/c_2 = (c_3 - 2 c_4)/(2 c_2)
///
/// c_k(|psi|^2) are Stumpff's functions: exact to rounding at any angle, zero included. T is singular at whole turns
/// |psi| = 2 pi n, n > 0: there the change of a rotation vector cannot follow every spin. `shortened` leads away from
/// them.

#include <Eigen/Dense>

namespace strandyn::math {

/// skew(v) u = v x u.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d S;
  S << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return S;
}

/// skew(v) M: v x each column.
inline Eigen::Matrix3d crossed(const Eigen::Vector3d& v, const Eigen::Matrix3d& M) {
  Eigen::Matrix3d out;
  out.row(0) = v.y() * M.row(2) - v.z() * M.row(1);
  out.row(1) = v.z() * M.row(0) - v.x() * M.row(2);
  out.row(2) = v.x() * M.row(1) - v.y() * M.row(0);
  return out;
}

/// The rotation about psi by the angle |psi|, of any size.
Eigen::Matrix3d rotation(const Eigen::Vector3d& psi);

/// The shortest rotation vector of R, at most pi long; of the two that are pi long, one. Each component is exact to
/// rounding of the whole, for tiny rotations relative to their size.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);

/// T: from the change of the rotation vector to the spin in fixed axes.
Eigen::Matrix3d spin_map(const Eigen::Vector3d& psi);

/// T^-1, for |psi| < 2 pi.
Eigen::Matrix3d inverse_spin_map(const Eigen::Vector3d& psi);

/// d(T(psi)^T m)/dpsi: T^T m is the moment that works on dpsi where m works on the spin.
Eigen::Matrix3d spin_map_transposed_slope(const Eigen::Vector3d& psi, const Eigen::Vector3d& m);

/// d(T(psi)^-T m)/dpsi, for |psi| < 2 pi.
Eigen::Matrix3d inverse_spin_map_transposed_slope(const Eigen::Vector3d& psi, const Eigen::Vector3d& m);

/// A rotation vector and how fast it changes. [rad], [rad/s]
struct RotationState {
  Eigen::Vector3d psi = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
};

/// The same rotation with |psi| <= pi, turning at the same angular velocity. Unchanged where it is that short.
RotationState shortened(const RotationState& state);

}  // namespace strandyn::math
