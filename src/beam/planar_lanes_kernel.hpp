#pragma once
/// \file The planar chain with elements in lanes, compiled once per instruction set (planar_lanes_kernel.cpp).

#include "element_rows.hpp"
#include "strandyn/beam/rigid_inertia.hpp"

namespace strandyn::beam::planar_lanes_kernel {

using lanes::most_lanes;
using lanes::place_in_tile;
using lanes::Rows;

enum Row : std::size_t {
  // Of an element, constant.
  span_x,      ///< [m]
  span_y,      ///< [m]
  length,      ///< [m] unstressed
  rest_angle,  ///< [rad]
  excess,      ///< [m^2] span^2 - length^2
  mass,        ///< [kg] mass/420
  // Of a node: where it is, how fast, its acceleration.
  x,
  y,
  turn,
  rate_x,
  rate_y,
  rate_turn,
  acceleration_x,
  acceleration_y,
  acceleration_turn,
  // Of an element at the position of the strains.
  chord,        ///< [m]
  along_x,      ///< [-] direction of the chord
  along_y,      ///< [-]
  rotation_1,   ///< [rad] in the chord's frame
  rotation_2,   ///< [rad]
  strain,       ///< [-]
  curvature_1,  ///< [1/m] at the Gauss points
  curvature_2,
  // Of the directions of its nodes, at a position whose rotations are `turned`.
  turned,  ///< [rad] of a node
  cosine_1,
  sine_1,
  cosine_2,
  sine_2,
  // Results: forces on its nodes.
  force_x_1,
  force_y_1,
  moment_1,
  force_x_2,
  force_y_2,
  moment_2,
  energy,  ///< [J]
  row_count
};

/// Numbers of an element's stiffness, from which its matrix is put together: ends move as one against the other.
enum StiffnessEntry : std::size_t {
  ends_xx,  ///< [N/m] forces on node 2 by its displacements
  ends_xy,
  ends_yx,
  ends_yy,
  by_turn_x_1,  ///< [N] forces on node 2 by either rotation
  by_turn_y_1,
  by_turn_x_2,
  by_turn_y_2,
  of_turn_x_1,  ///< [N] either moment by the displacements of node 2
  of_turn_y_1,
  of_turn_x_2,
  of_turn_y_2,
  turns_11,  ///< [N m] moments by rotations
  turns_12,
  turns_21,
  turns_22,
  stiffness_entries
};
/// And of its inertia: the same, but displacements of both nodes.
enum InertiaEntry : std::size_t {
  near_node,  ///< [kg/s^2] force on a node by its own displacement, and by that of the other
  far_node,
  node_1_by_turn_x_1,  ///< [kg m/s^2]
  node_1_by_turn_y_1,
  node_1_by_turn_x_2,
  node_1_by_turn_y_2,
  node_2_by_turn_x_1,
  node_2_by_turn_y_1,
  node_2_by_turn_x_2,
  node_2_by_turn_y_2,
  turn_1_by_node_x_1,
  turn_1_by_node_y_1,
  turn_1_by_node_x_2,
  turn_1_by_node_y_2,
  turn_2_by_node_x_1,
  turn_2_by_node_y_1,
  turn_2_by_node_x_2,
  turn_2_by_node_y_2,
  inertia_turns_11,  ///< [kg m^2/s^2]
  inertia_turns_12,
  inertia_turns_21,
  inertia_turns_22,
  inertia_entries
};

/// Derivatives of the resultants at the points, as `Rows` of points.
struct PointTangents {
  const double *N_eps, *N_chi, *M_eps, *M_chi;
};

void find_kinematics(const Rows& rows, double* eps, double* chi);
void find_internal_force(const Rows& rows, const double* N, const double* M);
void find_stiffness(const Rows& rows, const double* N, const double* M, const PointTangents& t, double* tiles);
void find_directions(const Rows& rows);
void find_inertia_force(const Rows& rows);
void find_inertia_tangent(const Rows& rows, const InertiaFactors& factors, double* tiles);
void find_kinetic_energy(const Rows& rows);

}  // namespace strandyn::beam::planar_lanes_kernel
