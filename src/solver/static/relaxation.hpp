#pragma once
/// \file To rest from a shape that Newton's method cannot reach rest from: a slack chain gives way through thick oil.
///
/// Steps of the overdamped motion alpha D du = f_ext - f_int(u), each by the implicit Euler rule: it minimizes
///     potential energy(u) + alpha/2 (u - u_n) . D (u - u_n)
/// near u_n, D the lengths (cubed, for rotations) that a node stands for. alpha falls while that goes well and rises
/// where a step does not converge or turns a node too far. Energy falls with every step, so that what is found is the
/// valley in which the chain was let go; the last step has alpha = 0. Friction is that of one step from the straight,
/// where the history was begun: it, too, is downhill, as long as no wire turns back.
/// [Rockafellar1976, proximal points; KelleyKeyes1998, pseudo-transient continuation]

#include "newton.hpp"

namespace strandyn::solver {

/// Rest under the dead loads, from `u`; the history of `system` is begun at the straight chain. Nothing where it is not
/// found.
std::optional<system::Vector> relax(system::System& system, PathNewton& newton, system::Vector u);

/// Does every element of the chain bend less than a shallow beam may: by less than one radian between its nodes?
bool bends_little(const system::System& system, const system::Vector& u);

}  // namespace strandyn::solver
