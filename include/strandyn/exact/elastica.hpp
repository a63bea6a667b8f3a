#pragma once
/// \file Large deflection of a cantilever, inextensible and without shear, under a force across its tip that keeps its
/// direction.
///
/// With the tip slope phi_0, s = sin(phi_0), k^2 = (1 + s)/2, sin(psi) = sqrt(s)/k:               [BisshoppDrucker1945]
///     sqrt(P L^2/EI) = F(psi, k),   w/L = 1 - [2 E(psi, k) - sqrt(2 s)]/F,   1 + u/L = sqrt(2 s)/F
/// (the differences of complete and incomplete integrals of the paper, put together by the addition theorem: nothing
/// cancels). Range: 0 <= P L^2/EI <= 1e5. w/L and u/L are right to 1e-15, absolutely.
/// Limits: P L^2/EI -> 0 gives w = P L^3/(3 EI); P L^2/EI = 1: w/L 0.301721, u/L -0.056433; 10: 0.810609, -0.554996.

namespace strandyn::exact {

struct CantileverLoad {
  double force = 0;   ///< [N] across the unloaded beam, at the tip
  double EI = 0;      ///< [N m^2]
  double length = 0;  ///< [m]
};

struct CantileverTip {
  double deflection = 0;  ///< [m] w, along the force
  double shortening = 0;  ///< [m] u, along the unloaded beam; negative
  double slope = 0;       ///< [rad] phi_0
};

CantileverTip cantilever_elastica(const CantileverLoad& load);

}  // namespace strandyn::exact
