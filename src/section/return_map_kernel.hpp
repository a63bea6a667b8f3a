#pragma once
/// \file The march of the return map over one batch, compiled once per instruction set (see return_map_kernel.cpp).

#include "batch_view.hpp"
#include "strandyn/section/return_map.hpp"

namespace strandyn::section::return_map_kernel {

using kernel::Energies;
using kernel::Response;
using kernel::Strains;

/// Layout of a block of the history: these rows of `block_lanes` doubles, then per layer, outermost first, the
/// gradients q of the tension side and of the compression side, one row per midpoint.
enum Row : std::size_t {
  committed_chi,    ///< [1/m] curvature at the last commit
  reference_chi,    ///< [1/m] curvature at the last commit that marched: q below belongs to it
  reference_eps,    ///< [-] its axial strain
  reference_M,      ///< [N m] its friction moment
  reference_U,      ///< [J/m] its stored energy of the friction part
  stick_low,        ///< [1/m] lowest chi - reference_chi without slip, at the reference strain
  stick_high,       ///< [1/m] highest
  stick_low_slack,  ///< [1/m] the same with the strain dropped by 1/inverse_drop
  stick_high_slack,
  inverse_drop,  ///< [-] 1/(strain drop of the slack box)
  scalar_rows
};

constexpr std::size_t rows_of_block(const PlanarCoefficients& c) {
  return scalar_rows + c.layers.size() * 2 * c.cosine.size();
}

/// Both return the number of points that had to march.
std::size_t respond(const PlanarCoefficients& c, const double* history, const Strains& strains,
                    const Response& response);
std::size_t commit(const PlanarCoefficients& c, double* history, const Strains& strains, const Energies& energies);

}  // namespace strandyn::section::return_map_kernel
