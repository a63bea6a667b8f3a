#pragma once
/// \file The planar chain with elements in lanes, compiled once per instruction set (planar_lanes_kernel.cpp).

#include <cstddef>

namespace strandyn::beam::planar_lanes_kernel {

/// Lanes of a register at most: rows are read and written in whole registers.
inline constexpr std::size_t most_lanes = 4;

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

/// All rows of a chain; whole registers of elements, and one node more than elements.
struct Rows {
  double* data;
  std::size_t stride;
  std::size_t elements;
};

void find_kinematics(const Rows& rows, double* eps, double* chi);
void find_internal_force(const Rows& rows, const double* N, const double* M);
void find_directions(const Rows& rows);
void find_inertia_force(const Rows& rows);
void find_kinetic_energy(const Rows& rows);

}  // namespace strandyn::beam::planar_lanes_kernel
