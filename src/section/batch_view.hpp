#pragma once
/// \file What kernels see of a batch: bare rows of doubles, padded to whole blocks.

#include <algorithm>

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

/// A history of zeros: for each block of points that many rows of `block_lanes` doubles.
inline History blank_history(std::size_t points, std::size_t rows_of_block) {
  return {.points = points, .data = AlignedVector(padded(points) * rows_of_block, 0.0)};
}

}  // namespace strandyn::section::kernel
