#pragma once
/// \file The spatial strand return map: tension, torsion, bending about both axes; limits follow the wire force.
///
/// A wire at polar angle theta feels only the projection of the curvature on that direction:
///     e(theta) = cos(theta) chi2 + sin(theta) chi3,   q_trial = q_n + k (e - e_n),   q = clip(q_trial, -q_lim, q_lim)
///     (M2, M3) = EI_min (chi2, chi3) + sum_j C_j mean_theta[(cos, sin)(theta) q],   C_j = n_j R_j^2 cos a_j/|sin a_j|
///     (N, M1)  = [EA, C_AT; C_AT, GJ] (eps, chi1)                                          [FM2016 (25), (26), (35)]
/// N midpoints cover the full turn, every wire of a layer runs through all of them. The limit at a midpoint follows the
/// wire force there (15); the sine is signed, twist tightens the lays of one hand and opens the others:
///     q_lim = max(floor, numerator + mu_int kappa F_b(theta)),       F_w = F_at + F_b
///     F_at  = EA_w (cos^2 a eps + R sin a cos a chi1),               F_b(theta) = F_0 + integral of (q - mean q) dS
/// Two numbers per layer close it: mean q, so that the force of the wire is the same after a full turn, and F_0, so
/// that F_b has zero mean over the two neutral points, phi = atan2(chi3, chi2) and phi + pi, where the turn crosses the
/// neutral plane. F_b at phi is interpolated inside its cell, so the limits move continuously with a turning plane.
/// Both numbers and the march are solved together, by Newton's method, to rounding (src/section/README.md).
///
/// Only the limits feel F_b. q itself is clipped point by point and feeds moment and energies as it is: mean q drops
/// out of the moment, and for any limits >= 0
///     U_f = sum_j C_j mean(q^2/(2k)),   D = sum_j C_j mean max(q_1 de_slip, (q_0 + q_1)/2 de_slip) >= 0
///     delta U_f + D - E_quad = trapezoidal work of the friction part of (M2, M3), exactly.
///
/// Where |chi| < 1e-12 1/m the neutral direction is undefined: the last one is kept. A path that slips, passes through
/// zero curvature and leaves in another direction therefore meets a step of second order, mu |sin a| of M, there.
///
/// Limits it reproduces: a planar path along a grid direction (a multiple of 2 pi/N) gives PlanarReturnMap to rounding;
/// turning a path by such an angle turns the answer; other directions differ by O(N^-2); a circular orbit of curvature
/// under a constant limit loses 4 C q_lim (|chi| - chi_cr) a turn; mu = 0 gives EI_min, mu without bound EI_max.
///
/// A point that cannot slip makes no march: at commit a kite of curvature increments is found in which every angle
/// sticks, its long diagonal along the last increment, shrinking as tension drops, twist moves or the neutral plane
/// turns. The limits are linear or convex in all of these, so it is safe; along its diagonal, nothing else moving, it
/// is exact.

#include "strandyn/section/return_map.hpp"

namespace strandyn::section {

struct SpatialReturnMapOptions {
  int points = 36;  ///< per turn of the lay, a multiple of 4
  /// Adds the bending part of the axial resultants, n cos a mean(F_b) to N and n R sin a mean(F_b) to M1: the full
  /// (33), (B.2) instead of the symmetric (35). Second order in mu sin a. Its work is no part of stored or dissipated:
  /// whoever keeps a ledger books it apart, from WireState::N_bending and M1_bending. No point skips its march then.
  bool axial_resultants = false;
};

/// Constants of the march over a full turn, outermost layer first.
struct SpatialCoefficients {
  /// As in the plane, except that `weight` is C_j/N: a point stands for 1/N of a mean.
  struct Layer : PlanarCoefficients::Layer {
    double stick_force = 0;     ///< [N m] F_b = this (sin(theta) chi2 - cos(theta) chi3) while all angles stick
    double torsion_weight = 0;  ///< [m] n R sin a/N: what a midpoint's F_b adds to M1
  };
  std::vector<Layer> layers;
  std::vector<double> cosine;  ///< at the N/4 midpoints of the first quarter turn
  std::vector<double> sine;
  int points = 0;
  double dtheta = 0;       ///< [rad] 2 pi/N
  double twist_drop = 0;   ///< [m] a twist changes no limit by more than this axial strain per twist does
  double EA = 0;           ///< [N]
  double GJ = 0;           ///< [N m^2]
  double C_AT = 0;         ///< [N m]
  double EI_min = 0;       ///< [N m^2]
  double EI_friction = 0;  ///< [N m^2] EI_max - EI_min
  bool axial_resultants = false;
};

SpatialCoefficients spatial_coefficients(const conductor::Strand& strand, const SpatialReturnMapOptions& options);

class SpatialReturnMap final : public Law {
 public:
  SpatialReturnMap(const conductor::Strand& strand, const SpatialReturnMapOptions& options)
      : c_(spatial_coefficients(strand, options)) {}

  std::string_view name() const override { return "return-map"; }
  Dimension dimension() const override { return Dimension::spatial; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;
  WireState wires(const History& history, const Field& committed_strains, std::size_t point) const override;

  const SpatialCoefficients& coefficients() const { return c_; }

 private:
  SpatialCoefficients c_;
};

}  // namespace strandyn::section
