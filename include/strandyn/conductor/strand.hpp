#pragma once
/// \file A strand as plain data: layers of helical wires around a core, in SI units.
///
/// Layer 0 is the core (helix radius 0, lay angle 0), the last layer is the outermost. A wire of a layer winds with
///     kappa = sin^2(alpha)/R,   dS = R dtheta/|sin(alpha)|,   dx = cos(alpha) dS              [FM2016 (6), (8)]
/// around the strand axis; a positive lay angle is a right-hand lay.

#include <optional>
#include <string>
#include <vector>

namespace strandyn::conductor {

/// Cross section of one wire. Area and inertia are inputs of the wire model; `round` is the default.
enum class WireShape { round, trapezoidal };

/// One layer of like wires. Lengths in m, angles in rad, moduli in Pa.
struct Layer {
  int wires = 1;
  double diameter = 0;        ///< [m] radial height of a wire
  double lay_angle = 0;       ///< [rad] signed, right-hand lay positive
  double helix_radius = 0;    ///< [m] of the wires' centre line; see `fill_helix_radii`
  double young = 0;           ///< [Pa]
  double poisson = 0.3;       ///< [-]
  double density = 0;         ///< [kg/m^3] 0: not given
  double residual_force = 0;  ///< [N/m of wire] radial, on the inner contact, from stranding; >= 0
  double friction_inner = 0;  ///< [-] Coulomb coefficient between this layer and the one below
  WireShape shape = WireShape::round;
  double wire_area = 0;     ///< [m^2] of one wire
  double wire_inertia = 0;  ///< [m^4] second moment of one wire about its own axis

  double EA_wire() const { return young * wire_area; }
  double EI_wire() const { return young * wire_inertia; }
};

/// A whole strand. `layers[0]` is the core.
struct Strand {
  std::string name;
  std::vector<Layer> layers;
  double mass_per_length = 0;  ///< [kg/m] of unstressed strand
  double rated_strength = 0;   ///< [N] 0: not known

  double outer_diameter() const;  ///< [m] over the outermost layer
  /// [kg/m] sum of n A rho/cos(alpha); nothing where a density is missing.
  std::optional<double> geometric_mass() const;
};

/// Area [m^2] and inertia [m^4] of a round wire of the given diameter [m].
double round_area(double diameter);
double round_inertia(double diameter);

/// Inertia [m^4] of a trapezoidal wire of given area [m^2] and radial height [m]: that of the rectangle of the same
/// area and height, averaged over the two axes (the wire turns once per lay, so bending sees the mean).
double trapezoid_inertia(double area, double height);

/// Sets each helix radius that is zero from radial contact: R_j = R_{j-1} + (d_{j-1} + d_j)/2.
void fill_helix_radii(Strand& strand);

/// Lay angle [rad] of a wire of helix radius `radius` [m] that turns once in `lay_length` [m], signed by `lay_length`.
double lay_angle_from_length(double radius, double lay_length);

/// What is wrong with the strand, in words, or nothing: each layer has wires, positive sizes and moduli,
/// |lay angle| < 90 deg, kappa d < 2 (the inner contact line must exist).
std::optional<std::string> find_fault(const Strand& strand);

}  // namespace strandyn::conductor
