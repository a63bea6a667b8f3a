#pragma once
/// \file Which unknowns a node of a chain has: a scene pays only for the motion that it speaks of.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace strandyn::model {

/// What a node can do: displacements along the global axes [m], rotations [rad]. Rotations are the components of a
/// total rotation vector; they turn about the global axes, in a chain without twist about the axes 2 and 3 of its
/// sections.
enum class Unknown : std::size_t { x, y, z, rotation_x, rotation_y, rotation_z };
inline constexpr std::size_t unknown_kinds = 6;

/// How a chain may move.
enum class Freedom {
  planar,             ///< x, y, rotation z
  spatial,            ///< all six
  spatial_untwisted,  ///< without rotation x: straight chains along x whose twist is held everywhere
  transverse_planar,  ///< y, rotation z: straight chains, one tension for all elements, axial inertia left out
  transverse_spatial  ///< y, z, rotation y, rotation z: the same in both planes
};

/// The unknowns of a node, in the order of the vectors.
std::span<const Unknown> unknowns_of(Freedom freedom);

/// Place of an unknown within its node, where the chain has it.
std::optional<std::size_t> place_of(Freedom freedom, Unknown unknown);

const char* name_of(Unknown unknown);  ///< "displacement x", "rotation z"

constexpr bool is_rotation(Unknown unknown) {
  return unknown >= Unknown::rotation_x;
}
constexpr bool is_spatial(Freedom f) {
  return f != Freedom::planar && f != Freedom::transverse_planar;
}
constexpr bool is_transverse(Freedom f) {
  return f == Freedom::transverse_planar || f == Freedom::transverse_spatial;
}

}  // namespace strandyn::model
