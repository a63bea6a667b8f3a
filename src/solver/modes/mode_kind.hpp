#pragma once
/// \file What kind of motion a mode is, and modes of equal frequency told apart.

#include "strandyn/solver/modes/modes.hpp"

namespace strandyn::solver {

/// A mode as the eigenvalue solver gives it.
struct RawMode {
  double eigenvalue = 0;  ///< [1/s^2] omega^2
  system::Vector shape;   ///< phi^T M phi = 1
};

/// Turns shapes of (nearly) equal eigenvalues among themselves so that each moves in one plane as far as it can.
void separate_planes(const model::Model& model, const system::Matrix& M, std::vector<RawMode>& modes);

/// Kind and scale of a mode.
Mode describe(const model::Model& model, const system::Matrix& M, const RawMode& raw);

}  // namespace strandyn::solver
