#pragma once
/// \file The integrals of products of the Hermite shapes, which planar and spatial inertia share.

#include <Eigen/Dense>

namespace strandyn::beam {

/// int H_a H_b over the element, for X = (x_1, t_1, x_2, t_2): [m], and [m^2] and [m^3] where a tangent takes part.
inline Eigen::Matrix4d hermite_table(double length) {
  const double l = length;
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l,              //
      22 * l, 4 * l * l, 13 * l, -3 * l * l,  //
      54, 13 * l, 156, -22 * l,               //
      -13 * l, -3 * l * l, -22 * l, 4 * l * l;
  return l / 420 * m;
}

}  // namespace strandyn::beam
