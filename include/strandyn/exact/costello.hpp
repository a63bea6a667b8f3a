#pragma once
/// \file Costello's theory of a straight strand of one layer under tension and twist: every wire a curved rod.
///
/// With the lay angle a (Costello's is its complement), primes for the deformed strand, eps and tau_s per unit of
/// unstressed length and nu R xi the thinning of a wire:                                        [Costello1990, ch. 3]
///     (1 + xi) cos a' = (1 + eps) cos a,    (1 + xi) sin a' = (r'/r)(sin a + r tau_s cos a)
///     r' = r - nu_1 R_1 xi_1 - nu_2 R_2 xi_2,    xi_1 = eps,  xi_2 = xi
///     G = EI_2 (sin^2 a'/r' - sin^2 a/r),  H = EI_2/(1+nu_2) (sin a' cos a'/r' - sin a cos a/r),  T = EA_2 xi_2
///     N_2 = H sin^2 a'/r' - G sin a' cos a'/r'                                     (shear force along the binormal)
///     N = EA_1 eps + n [T cos a' + N_2 sin a']
///     M = EI_1/(1+nu_1) tau_s + n [H cos a' + G sin a' + r' (T sin a' - N_2 cos a')]
/// Nonlinear in eps and tau_s; the layer rests on the core, its wires do not touch each other, no friction.
/// Range: a core and one layer; small strains, of any size that keeps r' positive.
/// The stiffness is not symmetric, even at small strain (dM/deps 8803, dN/dtau_s 9235 N m for the 1/6 strand without
/// contraction): G and H follow curvatures per deformed length, which are not what the equilibrium is conjugate to.
/// Deviation: without contraction r' = r is held, for comparison with the linear constants of `conductor`.

#include "strandyn/conductor/strand.hpp"

namespace strandyn::exact {

struct AxialTorsion {
  double strain = 0;  ///< [-] of the strand
  double twist = 0;   ///< [rad/m] of unstressed strand, right-hand positive
};

struct AxialTorsionResponse {
  AxialTorsion deformation;
  double N = 0;  ///< [N]
  double M = 0;  ///< [N m] torque, right-hand positive

  double k1() const { return N / deformation.strain; }  ///< [N]
  double k2() const { return N / M; }                   ///< [1/m]
};

enum class Contraction { poisson, none };

/// Both throw std::invalid_argument for a strand that is not a core and one layer.
AxialTorsionResponse costello(const conductor::Strand& strand, const AxialTorsion& deformation,
                              Contraction contraction);
/// The end free to turn: the twist at which the torque vanishes.
AxialTorsionResponse costello_free_end(const conductor::Strand& strand, double strain, Contraction contraction);

}  // namespace strandyn::exact
