#pragma once
/// \file The planar strand return map: stick-slip of every wire, friction limits that follow the wire force.
///
/// Every wire of a layer runs through all swept angles theta, so one set of points serves the layer. Planar bending is
/// symmetric about the plane of bending: two quarter turns tell all, the tension side (theta from 0 to pi/2) and the
/// compression side (0 to -pi/2), N/4 midpoints each. The state is the gradient q of the wire's bending force:
///     q_trial = q_n + k cos(theta) (chi - chi_n),   q = clip(q_trial, -q_lim, q_lim),   k = EA_w cos^2 a |sin a|
///     F_w(theta) = F_at + integral of q dS from the neutral plane,   dS = R dtheta/|sin a|
/// q_lim (conductor/contact.hpp) depends on F_w at the same midpoint, F_w = F_edge +- q dS/2: solved in closed form,
///     q = +-(A + B F_edge)/(1 -+ b),   b = mu_int |sin a| dtheta/2
/// and where 1 - b <= 0 no limit can be reached: the point sticks. The average force of a layer loads the next contact
/// inward; the march begins with the outermost layer. Integration by parts gives the moment straight from q:
///     M = EI_min chi + sum_j C_j mean_theta(cos(theta) q),     C_j = n_j R_j^2 cos a_j/|sin a_j|
///     U_f = sum_j C_j mean(q^2/(2k)),   D = sum_j C_j mean max(q_1 de_slip, (q_0 + q_1)/2 de_slip) >= 0
/// The bending part of the axial resultants is left out of N, as the paper's symmetric form (35) implies; the ledger
/// then closes exactly: delta U_f + D - E_quad = (M_0 + M_1)/2 delta chi, friction part.
///
/// Limits it reproduces: mu = 0 gives EI_min and no loss; mu without bound gives EI_max; no slip gives EI_max to
/// rounding. Error of the midpoint rule: O(N^-2), 0.14 % of chi_0 for Curlew at 36 points, 0.04 % at 72.
///
/// A point whose curvature since its last slip can reach no limit sticks at every angle: M follows EI_max and no march
/// is made. The range of curvature for which this is certain is found at a commit without slip; it is exact at the
/// committed tension and safe where the tension has dropped (the limits are linear in both, so a box between two boxes
/// is feasible).

#include "strandyn/conductor/strand.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::section {

/// Constants of the march, outermost layer first. Made once per strand and number of points.
struct PlanarCoefficients {
  struct Layer {
    double k = 0;                 ///< [N m] gradient per curvature: q_stick = k cos(theta) chi
    double weight = 0;            ///< [m^2] C_j times 2/N: what a point of one quarter turn stands for in a mean
    double half_step = 0;         ///< [m] dS/2
    double force_per_strain = 0;  ///< [N] F_at = this * eps
    double force_per_twist = 0;   ///< [N m] in space F_at has this * chi1, too
    double kappa = 0;             ///< [1/m]
    double c_ext = 0;             ///< [-]
    double inverse_c_int = 0;     ///< [-]
    double mu_int = 0;            ///< [-]
    double mu_ext = 0;            ///< [-]
    double inner_residual = 0;    ///< [N/m] c_int R_res
    double next_layer_ratio = 0;  ///< [-]
    double slope = 0;             ///< [1/m] B = mu_int kappa
    double outward_gain = 0;      ///< 1/(1 - b) where |F_w| grows with |q|; 0 where 1 - b <= 0
    double outward_offset = 0;    ///< [N/m] 0, or beyond reach where 1 - b <= 0
    double inward_gain = 0;       ///< 1/(1 + b)
    double limit_per_strain = 0;  ///< [N/m] the steepest d q_lim/d eps, all contacts closed
    double axial_weight = 0;      ///< n cos a/N: what the F_b of one of the N midpoints adds to N
  };
  std::vector<Layer> layers;
  std::vector<double> cosine;  ///< cos(theta) at the N/4 midpoints of a quarter turn
  double mean_weight = 0;      ///< 2/N
  double EA = 0;               ///< [N]
  double EI_min = 0;           ///< [N m^2]
  double EI_friction = 0;      ///< [N m^2] EI_max - EI_min
};

/// `points` per turn of the lay, a multiple of 4.
PlanarCoefficients planar_coefficients(const conductor::Strand& strand, int points);

class PlanarReturnMap final : public Law {
 public:
  PlanarReturnMap(const conductor::Strand& strand, int points) : c_(planar_coefficients(strand, points)) {}

  std::string_view name() const override { return "return-map"; }
  Dimension dimension() const override { return Dimension::planar; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;
  WireState wires(const History& history, const Field& committed_strains, std::size_t point) const override;

  const PlanarCoefficients& coefficients() const { return c_; }

 private:
  PlanarCoefficients c_;
};

/// The vector instructions that the kernels run with on this machine.
struct VectorTarget {
  const char* name = "";  ///< "AVX3" (AVX-512), "AVX2", "SSE4", ...
  std::size_t lanes = 0;  ///< doubles per register
};
VectorTarget vector_target();

}  // namespace strandyn::section
