#pragma once
/// \file Many of the lowest modes, slice by slice.
///
/// A Krylov space that holds n modes of a chain of N unknowns takes 4 n N numbers and some 8 n^2 N operations for every
/// time that it is built: minutes where n is hundreds. Slices of a few dozen modes, each about a frequency of its own,
/// take n/40 times as much as one of them. How many eigenvalues lie below a slice is told by the pivots of K - sigma M,
/// so that nothing is left out between two of them and nothing is counted twice.

#include <functional>

#include "nearest.hpp"

namespace strandyn::solver {

inline constexpr std::size_t slice_size = 48;

/// The lowest modes, rigid ones first, until they are `enough`, which is asked after every slice; or up to the half of
/// what the mesh carries. Throws ComputationError, Interrupted.
std::vector<RawMode> lowest_in_slices(const system::System& system, const Pencil& pencil,
                                      const std::vector<RawMode>& rigid, const Stop& stop,
                                      const std::function<bool(const std::vector<RawMode>&)>& enough);

}  // namespace strandyn::solver
