#pragma once
/// \file The compliant march around the turn over one batch, compiled once per instruction set
/// (spatial_compliant_kernel.cpp).

#include "compliant_kernel.hpp"
#include "strandyn/section/spatial_compliant.hpp"

namespace strandyn::section::spatial_compliant_kernel {

/// Layout of a block of the history: these rows of `block_lanes` doubles, a row of stiffness per interface, outermost
/// first; per layer the two rows of `LayerRow`; then per midpoint from 0 to pi the cell there before the one at the
/// opposite angle -theta, per interface the rows of
/// `compliant_kernel::InterfaceRow`.
enum Row : std::size_t {
  committed_chi2,  ///< [1/m]
  committed_chi3,
  last_step2,  ///< [1/m] of the curvature at the last commit
  last_step3,
  neutral,      ///< neutral angle in cells, from 0 to N/2
  peak_strain,  ///< [-] the largest committed axial strain
  lanes,        ///< width of the registers that committed, for the windows of springs
  stiffness     ///< [N/m^2] of the interfaces at that strain
};

/// The numbers that close a layer.
enum LayerRow : std::size_t {
  start_force,    ///< [N] F_b at theta = 0
  mean_gradient,  ///< [N/m] mean q
  layer_rows
};

inline std::size_t first_layer(const SpatialCompliantCoefficients& c) {
  return stiffness + c.angle.layers.size();
}
inline std::size_t first_cell(const SpatialCompliantCoefficients& c) {
  return first_layer(c) + layer_rows * c.angle.layers.size();
}
inline std::size_t rows_of_block(const SpatialCompliantCoefficients& c) {
  return first_cell(c) + 2 * c.cosine.size() * compliant_kernel::rows_of_cell(c.angle);
}

using kernel::Energies;
using kernel::SpatialResponse;
using kernel::SpatialStrains;

void respond(const SpatialCompliantCoefficients& c, const double* history, const SpatialStrains& strains,
             const SpatialResponse& response);
void commit(const SpatialCompliantCoefficients& c, double* history, const SpatialStrains& strains,
            const Energies& energies);

}  // namespace strandyn::section::spatial_compliant_kernel
