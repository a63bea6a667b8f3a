#pragma once
/// \file Section points side by side: one array per component, so that a law runs over many points at once.
///
/// Generalized strains and their work-conjugate resultants, in this order:
///     axial     eps  [-]      N  [N]
///     torsion   chi1 [rad/m]  M1 [N m]
///     bending2  chi2 [1/m]    M2 [N m]
///     bending3  chi3 [1/m]    M3 [N m]
/// A planar batch carries axial and bending2 only; the arrays of the others stay empty, and nobody pays for them.

#include <array>
#include <cstddef>

#include "strandyn/core/aligned.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::section {

enum class Component : std::size_t { axial, torsion, bending2, bending3 };
inline constexpr std::size_t component_count = 4;

using strandyn::Dimension;

/// Section points come in blocks of this many lanes: one register of AVX-512, two of AVX2, four of SSE4.
inline constexpr std::size_t block_lanes = 8;

/// The number of points rounded up to whole blocks.
constexpr std::size_t padded(std::size_t points) {
  return (points + block_lanes - 1) / block_lanes * block_lanes;
}

constexpr bool carries(Dimension dimension, Component c) {
  return dimension == Dimension::spatial || c == Component::axial || c == Component::bending2;
}

/// Strains or resultants of a batch. Entries beyond `points` are padding and stay zero.
class Field {
 public:
  Field() = default;
  Field(Dimension dimension, std::size_t points) : points_(points) {
    for (std::size_t c = 0; c < component_count; ++c) {
      if (carries(dimension, Component{c})) component_[c].assign(padded(points), 0.0);
    }
  }
  std::size_t points() const { return points_; }
  AlignedVector& operator[](Component c) { return component_[static_cast<std::size_t>(c)]; }
  const AlignedVector& operator[](Component c) const { return component_[static_cast<std::size_t>(c)]; }

 private:
  std::size_t points_ = 0;
  std::array<AlignedVector, component_count> component_;
};

/// d(resultant row)/d(strain column) of a batch.
class TangentField {
 public:
  TangentField() = default;
  TangentField(Dimension dimension, std::size_t points) {
    for (Field& row : rows_) row = Field(dimension, points);
  }
  AlignedVector& operator()(Component row, Component column) { return rows_[static_cast<std::size_t>(row)][column]; }
  const AlignedVector& operator()(Component row, Component column) const {
    return rows_[static_cast<std::size_t>(row)][column];
  }

 private:
  std::array<Field, component_count> rows_;
};

}  // namespace strandyn::section
