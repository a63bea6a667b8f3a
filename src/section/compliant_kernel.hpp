#pragma once
/// \file The march of the compliant law over one batch, compiled once per instruction set (see compliant_kernel.cpp).

#include <algorithm>
#include <cstdint>

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
  lanes,          ///< width of the registers that committed, for the windows of springs
  stiffness       ///< [N/m^2] of the interfaces at that strain
};

/// Of one interface at one midpoint.
enum InterfaceRow : std::size_t {
  traction,     ///< [N/m]
  last_slip,    ///< [m] of the wire outside it, along its own demand, in the last step
  limit_then,   ///< [N/m] its friction limit at the last commit
  window,       ///< of springs that need no look: `Window`
  held_there,   ///< [N/m] the sum of the forces of those that have room
  next_step,    ///< [N/m] K w for which they have it: more than the last step, with its sign
  needed,       ///< [N/m] the limit that they then need
  first_spring  ///< [N/m] the forces of all springs
};

/// Springs below `slid_to` stood at their limit, pushed on by the last step; those from `stuck_from` on have room.
struct Window {
  std::size_t slid_to, stuck_from;

  double packed() const { return static_cast<double>(slid_to * base + stuck_from); }
  /// Any number is some window of so many springs.
  static Window unpack(double x, std::size_t springs) {
    const std::uint32_t both = x >= 0 && x < base * base ? static_cast<std::uint32_t>(static_cast<std::int32_t>(x)) : 0;
    const std::size_t stuck = std::min<std::size_t>(both % base, springs);
    return {std::min<std::size_t>(both / base, stuck), stuck};
  }

 private:
  static constexpr std::uint32_t base = 1024;  // of springs at most
};

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
