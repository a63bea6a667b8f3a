#pragma once
/// \file The modes nearest to a frequency, by Lanczos on (K - sigma M)^-1 M (Spectra), and where they stand among all.

#include <vector>

#include "mode_kind.hpp"

namespace strandyn::solver {

/// Stiffness and mass of the free unknowns at a state; held ones have no mass and unit stiffness.
struct Pencil {
  system::Matrix K, M;

  Pencil(const system::System& system, const system::Vector& u);
};

std::size_t unknowns_with_mass(const system::System& system);

/// `options.count` modes nearest to `options.near` [Hz], the lowest ones for 0, ascending; no mode between them is left
/// out. The solver looks for those nearest in the square, which lean towards the lower ones. Rigid ones are known, and
/// left out where they are. Throws ComputationError, Interrupted.
std::vector<RawMode> nearest_to(const system::System& system, const Pencil& pencil, const ModeOptions& options,
                                const std::vector<RawMode>& rigid);

/// Modes of one frequency stand together; where they do not, they are a part 1e-6 of omega^2 apart at the least.
bool are_apart(const RawMode& lower, const RawMode& upper);

/// How many modes lie below this one and those of its frequency: the negative eigenvalues of K - sigma M.
std::size_t modes_below(const Pencil& pencil, const RawMode& mode);
/// How many lie below the first of some that follow each other; its group may be cut.
std::size_t modes_below(const Pencil& pencil, const std::vector<RawMode>& modes);

}  // namespace strandyn::solver
