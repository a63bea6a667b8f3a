#pragma once
/// \file The strand in planar bending with contacts that give: micro-slip, so that any vibration loses energy.
///
/// A wire of layer j that slips by u against plane sections, along its own demand and u ~ cos(theta) along its lay,
/// relaxes the gradient of its force:
///     k_j e = q_j + k_w,j u_j,     e = cos(theta) chi,  k = EA_w cos^2 a |sin a|,  k_w = EA_w (sin a/R)^2
/// and q_j is the traction of its contacts. The interface between layers j and j-1 has one traction T_j that acts on
/// both, and gives by both slips: by their sum where the lays cross, by their difference where they are equal,
///     q_j = T_j + a_j T_(j+1),     w_j = u_j + c_j u_(j-1),     u_0 = 0 for the core
/// (a, c with their signs: src/section/README.md). T follows w by Cattaneo and Mindlin,
///     T = T_lim [1 - (1 - w/w_star)^(3/2)]  where wires cross,   its antiplane sibling along a line (hertz.hpp)
/// with no fitted constant: geometry, elasticity and friction give T_lim and w_star. Small amplitudes lose
/// (2 - nu) Q^3/(18 G a mu P) per contact and cycle.
///
/// A contact is a parallel chain of elastic-plastic springs [Iwan 1966]: stiffness K kappa_i, limit T_lim phi_i,
///     f_i = clip(f_i,n + K kappa_i (w - w_n), -T_lim phi_i, T_lim phi_i),   sum kappa_i = sum phi_i = 1
/// so that moving limits, reversals, stored energy and loss need no rule book. The chain is graded: limits w_star r^-i,
/// down to `smallest_slip`. One chain loses too much and too little in turns while the amplitude passes its springs;
/// the angles of a layer have chains that are shifted against each other by parts of r, and together they are smooth.
///
/// T_lim follows the load at the midpoint of the cell: the wire force F_w = F_edge +- q dS/2 of this layer and, handed
/// inward at the same angle, of those outside. A cell is a system of one equation per layer, the slope of a convex
/// potential, piecewise linear: Newton's method ends on it. (The part of a cell's own q in its limit, mu_int |sin a|
/// dtheta/2, counts up to 0.9, which is a friction coefficient of 40 at 36 points; what lies beyond sticks anyway.)
///
/// K follows the axial strain: it belongs to the layer's mean force at the largest strain that the point has seen,
/// since a spot stays as wide as it has been pressed. It grows at constant spring force, which loses energy and never
/// gives any; were it to follow every strain, a tension that vibrates would wear out locked-in forces for no physical
/// reason.
///
/// Energies per unit length, C_j = n_j R_j^2 cos a_j/|sin a_j|, C_j k_w/k = n_j/cos a_j wires per length of strand:
///     U_f = sum_j C_j mean[q^2/(2k) + (k_w/k) sum_i f_i^2/(2 K_i)]
///     D   = sum_j C_j mean[(k_w/k) sum_i max(f_1 dw_slip, (f_0 + f_1)/2 dw_slip) + f_0^2/2 (1/K_0 - 1/K_1)] >= 0
/// with dw_slip of each spring; then delta U_f + D - E_quad = (M_0 + M_1)/2 delta chi, friction part, because
/// sum_j C_j (q_0 + q_1)/2 delta e = sum_j C_j [delta(q^2/(2k)) + (k_w/k) sum (f_0 + f_1)/2 delta w].
///
/// Limits it reproduces: compliance to zero is the return map for one layer, and for several as long as no layer is
/// dragged by the one outside it (README); mu = 0 gives EI_min and no loss; mu without bound is
/// elastic, with less than EI_max by what the contacts give; EI_min and EI_max bound every tangent at constant limits.
///
/// Every evaluation marches: some spring always slips. For bending about two axes: spatial_compliant.hpp.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/conductor/hertz.hpp"
#include "strandyn/conductor/slip_curve.hpp"
#include "strandyn/section/law.hpp"
#include "strandyn/section/return_map.hpp"

namespace strandyn::section {

struct CompliantOptions {
  int points = 36;              ///< per turn of the lay, a multiple of 4
  int springs = 17;             ///< of each contact, at least 4
  double smallest_slip = 3e-5;  ///< [-] of u_star: the loss is cubic above some four times this, and dies out below
  double compliance_scale = 1;  ///< [-] multiplies the compliance of every contact; > 0
  /// Chains of the angles shifted against each other. If not, all angles have one chain: then turns of the grid are
  /// exact in space, and the loss ripples by a tenth about the cube of a small amplitude.
  bool shifted_chains = true;
};

/// Around the core.
inline constexpr std::size_t most_compliant_layers = 12;

/// What is wrong with the options, in words, or nothing.
std::optional<std::string> find_fault(const CompliantOptions& options);

/// The springs of a contact on both sides of the neutral plane, from the smallest limit to the largest, a row each and
/// one more, and sums and bounds over them that spare a look at each. Sums go from the largest spring down.
class SpringTable {
 public:
  enum Column : std::size_t {
    // What a spring is looked at for lies in one line of the cache, what spares the look in the next.
    kappa,       ///< [-] part of the contact's first stiffness
    phi,         ///< [-] part of its limit
    per_kappa,   ///< [-]
    per_phi,     ///< [-]
    pull_below,  ///< [-] smallest kappa/phi of the springs below this one
    phi_below,   ///< [-] the sum of their phi
    kappa_from,  ///< [-] sum of kappa of the springs from this one on
    pull_from,   ///< [-] their largest kappa/phi
    columns
  };
  static constexpr std::size_t row_length = 2 * columns;  ///< tension side, compression side, column by column

  explicit SpringTable(const std::array<conductor::SpringChain, 2>& sides);
  std::size_t springs() const { return springs_; }
  const double* row(std::size_t spring) const { return rows_.data() + spring * row_length; }

 private:
  std::size_t springs_;
  AlignedVector rows_;
};

struct CompliantCoefficients {
  /// A layer and the interface inside it.
  struct Layer {
    double k_w = 0;                ///< [N/m^2]
    double wires_per_length = 0;   ///< [-] n/cos a: length of its wires per length of strand
    double own_load = 0;           ///< [-] kappa dS/2: what a cell's own gradient adds to its load
    double load_of_outer = 0;      ///< [-] h: load handed in by the layer outside, per load of its inner contact
    double traction_of_outer = 0;  ///< [-] a: h where the lays cross, -h where they are equal
    double slip_of_inner = 0;      ///< [-] c: what a slip of the layer inside adds to that of the interface
    conductor::Interface face;
    std::vector<SpringTable> chains;  ///< at a midpoint of a quarter turn
  };
  PlanarCoefficients planar;
  std::vector<Layer> layers;  ///< outermost first, like planar.layers
  std::size_t springs = 0;
  double compliance_scale = 1;
};

/// The same for the plane and for space. Throws std::invalid_argument beyond `most_compliant_layers`.
CompliantCoefficients compliant_coefficients(const conductor::Strand& strand, const CompliantOptions& options);

class CompliantLaw final : public Law {
 public:
  explicit CompliantLaw(const conductor::Strand& strand, const CompliantOptions& options = {})
      : c_(compliant_coefficients(strand, options)) {}

  std::string_view name() const override { return "compliant"; }
  Dimension dimension() const override { return Dimension::planar; }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;

 private:
  CompliantCoefficients c_;
};

}  // namespace strandyn::section
