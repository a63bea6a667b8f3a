#pragma once
/// \file Planar 2-node corotational Euler-Bernoulli element: large rotations, small strains.
///
/// The chord of current length l and direction alpha carries a frame; in it the element bends as a shallow Hermite
/// beam:
///     u = (l^2 - l0^2)/(l + l0),   t_i = theta_i + beta0 - alpha  (wrapped to +-pi)
///     eps = u/l0 + (2 t_1^2 - t_1 t_2 + 2 t_2^2)/30,     chi(xi) = [(6 xi - 4) t_1 + (6 xi - 2) t_2]/l0
/// eps is the mean over the element of u' + v'^2/2: one value for both Gauss points, so the membrane cannot lock, and
/// the tension's geometric stiffness acts inside the element, not only along the chord.            [C1991, BP2002] A
/// rigid motion gives no strain, to rounding, whatever the angle.
///
/// Nodal unknowns: displacements x, y [m] from the reference position and the rotation theta [rad]. Rotations count
/// turns; an element may bend by less than half a turn between its nodes.

#include <Eigen/Dense>
#include <array>

namespace strandyn::beam {

using PlanarVector = Eigen::Matrix<double, 6, 1>;  ///< (x1, y1, theta1, x2, y2, theta2)
using PlanarMatrix = Eigen::Matrix<double, 6, 6>;

/// Gauss points per element, and where they lie between the nodes (0 to 1).
inline constexpr std::size_t gauss_points = 2;
inline constexpr std::array<double, gauss_points> gauss_position = {0.21132486540518711775, 0.78867513459481288225};
inline constexpr double gauss_weight = 0.5;

/// What an element is. Constant during a run.
struct PlanarElement {
  Eigen::Vector2d span = {1, 0};  ///< [m] from node 1 to node 2 in the reference configuration
  double length = 1;              ///< [m] unstressed
  double rest_angle = 0;          ///< [rad] direction of the unbent element where both rotations are zero
};

/// What an element does in a given position.
struct PlanarKinematics {
  double eps = 0;                          ///< [-] axial strain
  std::array<double, gauss_points> chi{};  ///< [1/m] curvature at the Gauss points
  double chord = 1;                        ///< [m] current length of the chord
  Eigen::Vector2d direction = {1, 0};      ///< of the chord
  std::array<double, 2> rotation{};        ///< [rad] nodal rotations in the chord's frame
};

PlanarKinematics kinematics(const PlanarElement& element, const PlanarVector& q);

/// Section resultants at the Gauss points. [N], [N m]
struct PlanarResultants {
  std::array<double, gauss_points> N{};
  std::array<double, gauss_points> M{};
};

/// Their derivatives with respect to eps and chi of the same Gauss point.
struct PlanarSectionTangent {
  std::array<double, gauss_points> N_eps{}, N_chi{}, M_eps{}, M_chi{};
};

/// Internal force on the nodes: the derivative of the work of the resultants. [N], [N m]
PlanarVector internal_force(const PlanarElement& element, const PlanarKinematics& k, const PlanarResultants& r);

/// Its derivative with respect to the nodal unknowns, material and geometric part; symmetric where the section's is.
PlanarMatrix tangent(const PlanarElement& element, const PlanarKinematics& k, const PlanarResultants& r,
                     const PlanarSectionTangent& t);

}  // namespace strandyn::beam
