#pragma once
/// \file The spatial chain with elements in lanes, compiled once per instruction set: rows, and what is made of them.
/// Vectors take three rows, x first; matrices nine, column by column.

#include "element_rows.hpp"
#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/beam/spatial_lanes.hpp"

namespace strandyn::beam::spatial_lanes_kernel {

using lanes::Rows;

enum Row : std::size_t {
  // Of an element, constant.
  span = 0,           ///< [m]
  length = span + 3,  ///< [m] unstressed
  excess,             ///< [m^2] span^2 - length^2
  triad,              ///< [-] axes of the unbent section
  mass = triad + 9,   ///< [kg] mass/420
  twist_inertia,      ///< [kg m^2] polar inertia/12
  // Of a node, constant.
  moment,  ///< [kg m^2] xx, yx, zx, yy, zy, zz of the body that turns with it
  // Of a node: displacement and rotation vector, their rates and accelerations.
  position = moment + 6,
  rotation = position + 3,
  rate = rotation + 3,
  rotation_rate = rate + 3,
  acceleration = rotation_rate + 3,
  rotation_acceleration = acceleration + 3,
  // Of a node in its position.
  coefficients = rotation_acceleration + 3,  ///< c_1 to c_7, see math/stumpff.hpp
  turn = coefficients + 7,                   ///< Exp(psi)
  spin_map = turn + 9,                       ///< T
  // Of an element in its position.
  chord = spin_map + 9,  ///< [m]
  frame,                 ///< e1, e2, e3
  lean = frame + 9,
  upright,
  angle_1,  ///< [rad] rotations of the nodes in the frame
  angle_2 = angle_1 + 3,
  inverse_1 = angle_2 + 3,  ///< coefficient of S^2 in T^-1 of these, and its derivative by their squares
  inverse_slope_1,
  inverse_2,
  inverse_slope_2,
  direction_1,  ///< n_i in the frame
  direction_2 = direction_1 + 3,
  strain = direction_2 + 3,  ///< [-]
  twist,                     ///< [1/m]
  bend_2,                    ///< [1/m] about axis 2 at the Gauss points
  bend_3 = bend_2 + 2,       ///< about axis 3
  // Of a node in motion.
  spin = bend_3 + 2,            ///< [rad/s] w
  spin_rate = spin + 3,         ///< [rad/s^2] w'
  spin_change = spin_rate + 3,  ///< change of w seen from the node with its psi, by the factors of a matrix
  spin_rate_change = spin_change + 9,
  body_torque = spin_rate_change + 9,  ///< [N m] of the body, on psi
  body_tangent = body_torque + 3,
  // Results: forces on the nodes of an element, each with the moment on psi.
  force_1 = body_tangent + 9,
  moment_1 = force_1 + 3,
  force_2 = moment_1 + 3,
  moment_2 = force_2 + 3,
  energy = moment_2 + 3,  ///< [J]
  row_count
};

// Nodes (spatial_nodes_kernel.cpp): from `rotation`; with rates and accelerations; what a matrix needs of these; the
// bodies that turn with them.
void find_turns(const Rows& rows);
void find_spins(const Rows& rows);
void find_spin_changes(const Rows& rows, const InertiaFactors& factors);
void find_rotary_torques(const Rows& rows);
void find_rotary_tangents(const Rows& rows, const InertiaFactors& factors);
// Elements: from turns to strains, from resultants to forces (spatial_strains_kernel.cpp).
void find_kinematics(const Rows& rows);
void give_strains(const Rows& rows, const SpatialLanes::Strains& strains);
void find_internal_force(const Rows& rows, const SpatialLanes::Points& resultants);
// (spatial_stiffness_kernel.cpp)
void add_stiffness(const Rows& rows, const SpatialLanes::Points& resultants,
                   const SpatialLanes::PointTangents& tangents, const SpatialLanes::Blocks& K);
// Inertia (spatial_inertia_kernel.cpp), from spins.
void find_inertia_force(const Rows& rows);
void add_inertia_tangent(const Rows& rows, const InertiaFactors& factors, const SpatialLanes::Blocks& K);
void find_kinetic_energy(const Rows& rows);

}  // namespace strandyn::beam::spatial_lanes_kernel
