#pragma once
/// \file Spatial 2-node corotational Euler-Bernoulli element: large rotations, small strains.
///
/// A frame F = [e1 e2 e3] rides on the element: e1 along the chord, e2 and e3 from the mean p of the two nodal
/// directions n_i = R_i triad.col(1):  e3 = e1 x p/|e1 x p|,  e2 = e3 x e1.  In it the element is a shallow Hermite
/// beam in two planes with one twist; a and b are the components k of the two nodal rotations theta_i = log(F^T R_i
/// triad):
///     u = (l^2 - l0^2)/(l + l0),   eps = u/l0 + sum over k = 2, 3 of (2 a^2 - a b + 2 b^2)/30
///     chi1 = (theta_21 - theta_11)/l0,   chi_k(xi) = [(6 xi - 4) a + (6 xi - 2) b]/l0            [C1997, BP2002]
/// It is planar_element.hpp in each of its planes: a motion in the x-y plane gives the same eps, forces and tangent,
/// and the planar chi as chi3. A rigid motion gives no strain, to rounding, whatever the angle.
///
/// Nodal unknowns: displacements x, y, z [m] from the reference position and the total rotation vector psi [rad], all
/// in global axes. Moments work on dpsi, so the force is the gradient of the energy and the tangent its Hessian
/// wherever the section has an energy. psi may count turns; at whole turns (|psi| = 2 pi n) the force stays right but
/// the tangent is singular: an equation is solved with |psi| < 2 pi, see math::shortened. An element may bend and twist
/// by less than half a turn between its frame and its nodes.

#include <Eigen/Dense>
#include <array>

#include "strandyn/beam/planar_element.hpp"

namespace strandyn::beam {

using SpatialVector = Eigen::Matrix<double, 12, 1>;  ///< (x1, y1, z1, psi1 x, y, z, the same of node 2)
using SpatialMatrix = Eigen::Matrix<double, 12, 12>;

/// What an element is. Constant during a run.
struct SpatialElement {
  Eigen::Vector3d span = {1, 0, 0};  ///< [m] from node 1 to node 2 in the reference configuration
  double length = 1;                 ///< [m] unstressed
  /// Columns: the section's axes 1 (along), 2 and 3 of the unbent element where both nodal rotations are zero.
  Eigen::Matrix3d triad = Eigen::Matrix3d::Identity();
};

/// What a node does, seen from the element.
struct SpatialNode {
  Eigen::Vector3d psi;        ///< [rad] its unknown
  Eigen::Matrix3d spin_map;   ///< from dpsi to its spin, global axes
  Eigen::Vector3d rotation;   ///< [rad] theta_i, in the frame
  Eigen::Matrix3d from_spin;  ///< from a spin against the frame, in its axes, to the change of theta_i
  Eigen::Vector3d direction;  ///< n_i in the frame
};

/// What an element does in a given position.
struct SpatialKinematics {
  double eps = 0;                                       ///< [-] axial strain
  double chi1 = 0;                                      ///< [1/m] twist
  std::array<double, gauss_points> chi2{}, chi3{};      ///< [1/m] curvatures at the Gauss points, about axes 2 and 3
  double chord = 1;                                     ///< [m] current length of the chord
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  ///< e1, e2, e3
  double lean = 0;                                      ///< p.e1/p.e2
  double upright = 1;                                   ///< p.e2
  std::array<SpatialNode, 2> node;
};

SpatialKinematics kinematics(const SpatialElement& element, const SpatialVector& q);

/// Section resultants at the Gauss points. [N], [N m]
struct SpatialResultants {
  std::array<double, gauss_points> N{}, M1{}, M2{}, M3{};
};

/// Their derivatives at each Gauss point: d(N, M1, M2, M3)/d(eps, chi1, chi2, chi3). Need not be symmetric.
struct SpatialSectionTangent {
  std::array<Eigen::Matrix4d, gauss_points> C = {Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero()};
};

/// Internal force on the nodes: the derivative of the work of the resultants. [N], [N m]
SpatialVector internal_force(const SpatialElement& element, const SpatialKinematics& k, const SpatialResultants& r);

/// Its derivative with respect to the nodal unknowns, material and geometric part; symmetric where the section's is.
SpatialMatrix tangent(const SpatialElement& element, const SpatialKinematics& k, const SpatialResultants& r,
                      const SpatialSectionTangent& t);

}  // namespace strandyn::beam
