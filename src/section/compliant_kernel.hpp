#pragma once
/// \file The march of the compliant law over one batch, compiled once per instruction set (see compliant_kernel.cpp).

#include "batch_view.hpp"
#include "strandyn/section/compliant.hpp"

namespace strandyn::section::compliant_kernel {

using kernel::Energies;
using kernel::Response;
using kernel::Strains;

/// Layout of a block of the history: these rows of `block_lanes` doubles, then per layer, outermost first, per
/// midpoint, tension side before compression side, the forces of the inner contact's springs and of the outer one's.
enum Row : std::size_t {
  committed_chi,  ///< [1/m]
  peak_strain,    ///< [-] the largest committed axial strain
  scalar_rows
};

inline std::size_t rows_of_block(const CompliantCoefficients& c) {
  std::size_t contacts = 0;
  for (const CompliantCoefficients::Layer& layer : c.layers) contacts += layer.contacts;
  return scalar_rows + contacts * 2 * c.planar.cosine.size() * c.springs;
}

/// Stiffness of every contact, inner and outer of each layer in turn, and its derivative by the strain, for one lane.
struct StiffnessOut {
  double* value = nullptr;  ///< stride block_lanes
  double* slope = nullptr;  ///< the same; may be null
};
void contact_stiffness(const CompliantCoefficients& c, double strain, const StiffnessOut& out);

void respond(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& response);
void commit(const CompliantCoefficients& c, double* history, const Strains& strains, const Energies& energies);

}  // namespace strandyn::section::compliant_kernel
