#pragma once
/// \file The march over full turns of one batch, compiled once per instruction set (spatial_return_map_kernel.cpp).

#include "batch_view.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::section::spatial_kernel {

/// Layout of a block of the history: these rows of `block_lanes` doubles, then the layers, outermost first. The
/// reference is the last commit that marched; the gradients belong to it.
enum Row : std::size_t {
  committed_eps,
  committed_twist,
  committed_chi2,
  committed_chi3,
  neutral,  ///< neutral angle in cells, from 0 to N/2: phi and phi + pi are the same plane
  reference_eps,
  reference_twist,
  reference_chi2,
  reference_chi3,
  reference_M2,  ///< [N m] friction part
  reference_M3,
  reference_U,  ///< [J/m] friction part
  axis2,        ///< unit vector of the kite's long diagonal
  axis3,
  stick_middle,    ///< [1/m] middle of the long diagonal, along the axis from the reference
  inverse_length,  ///< [m] one over half of the long diagonal
  inverse_width,   ///< [m] one over half of the short one, which crosses the middle
  inverse_drop,    ///< [-] one over the loss of axial strain after which the middle, too, slips
  offset_drop,     ///< [-] strain loss that covers the move of F_0, per |sin| of the neutral plane's turn
  scalar_rows
};

/// `stick_middle` of a point without a kite: with the largest inverse_length it is out of everybody's reach.
inline constexpr double no_kite = 1e9;
inline constexpr double without_bound = 1e150;  ///< products of two of them stay finite

/// Head of a layer, followed by N rows of gradients.
enum LayerRow : std::size_t {
  start_of_quarter,     ///< [N] F_b - mean(q) dS/2 at the beginning of each of the four quarter turns
  closure = 4,          ///< [N/m] mean(q)
  reference_numerator,  ///< [N/m] of the limit
  layer_scalar_rows
};

inline std::size_t rows_of_layer(const SpatialCoefficients& c) {
  return layer_scalar_rows + static_cast<std::size_t>(c.points);
}
inline std::size_t rows_of_block(const SpatialCoefficients& c) {
  return scalar_rows + c.layers.size() * rows_of_layer(c);
}

using Strains = kernel::SpatialStrains;
using Response = kernel::SpatialResponse;
using kernel::Energies;

/// Both return the number of points that had to march.
std::size_t respond(const SpatialCoefficients& c, const double* history, const Strains& strains,
                    const Response& response);
std::size_t commit(const SpatialCoefficients& c, double* history, const Strains& strains, const Energies& energies);

}  // namespace strandyn::section::spatial_kernel
