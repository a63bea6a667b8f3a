#pragma once
/// \file The closed virgin curve of all layers for one block of points, compiled once per instruction set.

#include <span>

#include "strandyn/section/batch.hpp"

namespace strandyn::section::masing_kernel {

/// Friction part of a block on the virgin curve, one entry per lane.
struct VirginCurve {
  alignas(64) double moment[block_lanes];      ///< [N m] odd in h
  alignas(64) double tangent[block_lanes];     ///< [N m^2]
  alignas(64) double stored[block_lanes];      ///< [J/m]
  alignas(64) double dissipated[block_lanes];  ///< [J/m] exactly zero where no layer slips
};

/// `h` [1/m]: curvature of the lanes, 64-byte aligned. `critical` [1/m]: c of each layer, a row of lanes after another.
void virgin_curve(std::span<const double> EI_layer, const double* critical, const double* h, VirginCurve& out);

}  // namespace strandyn::section::masing_kernel
