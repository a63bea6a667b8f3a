#pragma once
/// \file Natural frequencies and mode shapes about the committed state, all friction sticking at first.
///
///     K phi = omega^2 M phi,   phi^T M phi = 1
/// K is the tangent at the committed state, its symmetric part. Unknowns without mass follow the others.

#include <vector>

#include "strandyn/system/system.hpp"

namespace strandyn::solver {

struct Mode {
  double frequency = 0;   ///< [Hz]
  system::Vector shape;   ///< all unknowns; scaled to 1 m (or 1 rad) at its largest translation
  double modal_mass = 0;  ///< [kg] of that scaling
};

/// The `count` lowest modes, ascending. Throws ComputationError where the state is unstable or the solver stalls.
std::vector<Mode> lowest_modes(const system::System& system, const system::Vector& u, std::size_t count);

/// The modes whose motion is mainly across the span (y): what "mode 12" counts.
std::vector<Mode> transverse_modes(const system::System& system, const system::Vector& u, std::size_t count);

}  // namespace strandyn::solver
