#pragma once
/// \file Motions that strain nothing: a chain that its supports leave free to move as one piece has modes of frequency
/// zero, which an eigenvalue solver finds as noise, and whose stiffness has no inverse.
///
/// Of the six motions of a rigid body (fewer where the chain has no such unknowns) those combinations that no support
/// hinders, and of these the ones that meet no stiffness: weight and tension may hold what supports do not.

#include "mode_kind.hpp"

namespace strandyn::solver {

/// Orthonormal with respect to M, eigenvalue exactly 0; none where the chain is held. K and M are those of the free
/// unknowns, at a state u.
std::vector<RawMode> find_rigid(const system::System& system, const system::Vector& u, const system::Matrix& K,
                                const system::Matrix& M);

/// [1/s^2] a shift below zero, as near to it as rounding of K allows.
double shift_of_free_chain(const system::Matrix& K, const system::Matrix& M);

}  // namespace strandyn::solver
