#pragma once
/// \file Contacts that give before they slide (compliant.hpp), for bending about both axes, tension and twist.
///
/// A wire at polar angle theta feels the projection of the curvature on its direction; everything that happens at one
/// angle, wires and interfaces of all layers, is the cell of the planar law:
///     e(theta) = cos(theta) chi2 + sin(theta) chi3
///     (M2, M3) = EI_min (chi2, chi3) + sum_j C_j mean_theta[(cos, sin)(theta) q]
///     (N, M1)  = [EA, C_AT; C_AT, GJ] (eps, chi1)
/// N midpoints cover the full turn. Limits follow the force of the wires at the same angle,
///     F_w = F_at + F_b,   F_at = EA_w (cos^2 a eps + R sin a cos a chi1),   F_b = F_0 + integral of (q - mean q) dS
/// and mean q and F_0 of every layer close it as in spatial_return_map.hpp: the force is the same after a full turn,
/// and has zero mean over the two neutral points, phi = atan2(chi3, chi2) and phi + pi. Here one angle holds all
/// layers, so these two numbers of all layers are one system: Newton's method over marches of the turn, to rounding.
///
/// Only the limits feel F_b. Whatever it is, the ledger of the planar law closes and D >= 0. Its energies hold as they
/// are, with means over the full turn.
///
/// Limits it reproduces: a planar path about axis 2 is CompliantLaw to rounding. Where all angles share one chain
/// (`shifted_chains` false), a planar path along any direction of the grid is, and turning a path by an angle of the
/// grid turns the answer. With the shifted chains of the default other directions differ by the ripple of the chains:
/// less than one per cent with 24 springs, up to two with 17.
/// The stiffness of the contacts belongs to the largest axial strain, as in the plane; twist does not move it.

#include "strandyn/section/compliant.hpp"

namespace strandyn::section {

/// Springs of a contact that keep all directions of bending within one per cent.
inline constexpr int springs_in_space = 24;

struct SpatialCompliantCoefficients {
  /// Weights are those of the plane, where a point stands for 2/N of a mean; here it stands for half of that.
  CompliantCoefficients angle;
  std::vector<double> cosine;  ///< at the N/2 midpoints from 0 to pi
  std::vector<double> sine;
  int points = 0;     ///< N
  double EA = 0;      ///< [N]
  double GJ = 0;      ///< [N m^2]
  double C_AT = 0;    ///< [N m]
  double EI_min = 0;  ///< [N m^2]
};

class SpatialCompliantLaw final : public Law {
 public:
  explicit SpatialCompliantLaw(const conductor::Strand& strand, const CompliantOptions& options = {});

  std::string_view name() const override { return "compliant"; }
  Dimension dimension() const override { return Dimension::spatial; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;

 private:
  SpatialCompliantCoefficients c_;
};

}  // namespace strandyn::section
