#pragma once
/// \file The march of the compliant law over one batch, compiled once per instruction set (see compliant_kernel.cpp).

#include "batch_view.hpp"
#include "strandyn/section/compliant.hpp"

namespace strandyn::section::compliant_kernel {

using kernel::Energies;
using kernel::Response;
using kernel::Strains;

/// Layout of a block of the history: these rows of `block_lanes` doubles, a row of stiffness per interface,
/// outermost first, then per midpoint, tension side before compression side, per interface the rows of `InterfaceRow`.
enum Row : std::size_t {
  committed_chi,  ///< [1/m]
  last_step,      ///< [1/m] of the curvature at the last commit
  peak_strain,    ///< [-] the largest committed axial strain
  stiffness       ///< [N/m^2] of the interfaces at that strain
};

/// Of one interface at one midpoint: its traction [N/m], the part of its stiffness that held at the last commit, the
/// forces of its springs [N/m].
enum InterfaceRow : std::size_t { traction, holding, first_spring };

inline std::size_t rows_of_interface(const CompliantCoefficients& c) {
  return first_spring + c.springs;
}
inline std::size_t rows_of_cell(const CompliantCoefficients& c) {
  return c.layers.size() * rows_of_interface(c);
}
inline std::size_t first_cell(const CompliantCoefficients& c) {
  return stiffness + c.layers.size();
}
inline std::size_t rows_of_block(const CompliantCoefficients& c) {
  return first_cell(c) + 2 * c.planar.cosine.size() * rows_of_cell(c);
}

/// Stiffness of every interface per length of a wire outside it, and its derivative by the strain, for one lane.
struct StiffnessOut {
  double* value = nullptr;  ///< stride block_lanes
  double* slope = nullptr;  ///< the same; may be null
};
void contact_stiffness(const CompliantCoefficients& c, double strain, const StiffnessOut& out);

/// Where a history keeps what its contacts remember of the axial strain.
struct ContactLayout {
  std::size_t rows_of_block, peak_strain, stiffness;
};
/// A history of springs at rest, contacts pressed by the axial part of the strains.
History pressed_history(const CompliantCoefficients& c, const ContactLayout& layout, const Field& strains);

void respond(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& response);
void commit(const CompliantCoefficients& c, double* history, const Strains& strains, const Energies& energies);

}  // namespace strandyn::section::compliant_kernel
