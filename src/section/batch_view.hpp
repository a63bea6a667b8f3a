#pragma once
/// \file What kernels see of a batch: bare rows of doubles, padded to whole blocks.

#include <algorithm>
#include <array>

#include "strandyn/section/law.hpp"

namespace strandyn::section::kernel {

struct Energies {
  double* stored = nullptr;
  double* dissipated = nullptr;
  double* quadrature_error = nullptr;
};
inline Energies view(StepEnergy& energy) {
  return {.stored = energy.stored.data(),
          .dissipated = energy.dissipated.data(),
          .quadrature_error = energy.quadrature_error.data()};
}

/// Strains of a planar batch.
struct Strains {
  std::size_t points = 0;
  const double* eps = nullptr;
  const double* chi = nullptr;
};
inline Strains planar_view(const Field& strains) {
  return {
      .points = strains.points(), .eps = strains[Component::axial].data(), .chi = strains[Component::bending2].data()};
}

/// Resultants of a planar batch whose N is EA eps.
struct Response {
  double* N = nullptr;
  double* M = nullptr;
  double* dM_dchi = nullptr;  ///< null: no tangent asked for
  double* dM_deps = nullptr;
};
inline Response planar_view(Field& stresses, TangentField* tangents, double EA) {
  using enum Component;
  Response out{.N = stresses[axial].data(), .M = stresses[bending2].data()};
  if (!tangents) return out;
  out.dM_dchi = (*tangents)(bending2, bending2).data();
  out.dM_deps = (*tangents)(bending2, axial).data();
  std::fill((*tangents)(axial, axial).begin(), (*tangents)(axial, axial).end(), EA);
  return out;
}

/// Strains of a spatial batch.
struct SpatialStrains {
  std::size_t points = 0;
  std::array<const double*, component_count> at{};
};
inline SpatialStrains spatial_view(const Field& strains) {
  SpatialStrains all{.points = strains.points(), .at = {}};
  for (std::size_t c = 0; c < component_count; ++c) all.at[c] = strains[Component{c}].data();
  return all;
}

/// Resultants of a spatial batch.
struct SpatialResponse {
  std::array<double*, component_count> stress{};
  bool tangent = false;  ///< asked for; else `stiffness` is empty
  std::array<std::array<double*, component_count>, component_count> stiffness{};
};
inline SpatialResponse spatial_view(Field& stresses, TangentField* tangents) {
  SpatialResponse out;
  out.tangent = tangents != nullptr;
  for (std::size_t row = 0; row < component_count; ++row) {
    out.stress[row] = stresses[Component{row}].data();
    if (!tangents) continue;
    for (std::size_t column = 0; column < component_count; ++column) {
      out.stiffness[row][column] = (*tangents)(Component{row}, Component{column}).data();
    }
  }
  return out;
}

/// A history of zeros: for each block of points that many rows of `block_lanes` doubles.
inline History blank_history(std::size_t points, std::size_t rows_of_block) {
  return {.points = points, .data = AlignedVector(padded(points) * rows_of_block, 0.0)};
}

}  // namespace strandyn::section::kernel
