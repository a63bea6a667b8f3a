#pragma once
/// \file The integrals of products of the Hermite shapes, which planar and spatial inertia share.

#include <Eigen/Dense>

namespace strandyn::beam {

/// m int H_a H_b over the element, for X = (x_1, t_1, x_2, t_2), with the mass m per length: [kg], and [kg m] and
/// [kg m^2] where a tangent takes part. Seven products: it is made in every residual.
inline Eigen::Matrix4d hermite_table(double mass, double length) {
  const double c = mass * length / 420;
  const double cl = c * length;
  const double cll = cl * length;
  const double near = 156 * c, far = 54 * c, near_turn = 22 * cl, far_turn = 13 * cl, turn = 4 * cll, turns = -3 * cll;
  Eigen::Matrix4d m;
  m.col(0) = Eigen::Vector4d(near, near_turn, far, -far_turn);
  m.col(1) = Eigen::Vector4d(near_turn, turn, far_turn, turns);
  m.col(2) = Eigen::Vector4d(far, far_turn, near, -near_turn);
  m.col(3) = Eigen::Vector4d(-far_turn, turns, -near_turn, turn);
  return m;
}

}  // namespace strandyn::beam
