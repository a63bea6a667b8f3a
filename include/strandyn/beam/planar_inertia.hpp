#pragma once
/// \file Inertia of the planar element: lumped, or consistent with the same shape for both directions of space.
///
/// Lumped: half of the element's mass at each node; rotations carry the rotary inertia, or nothing.
/// Consistent: the centre line is the Hermite curve through the nodes with the nodal tangents t = (cos, sin):
///     x(xi) = H1 x_1 + H2 l0 t_1 + H3 x_2 + H4 l0 t_2,      T = m/2 int |x'|^2 = 1/2 sum m_ab X_a' . X_b'
/// with the constant Hermite table m_ab and X = (x_1, t_1, x_2, t_2). The same table serves every direction, so the
/// kinetic energy is objective for any rotation; the velocity enters only through t'' = theta'' n - theta'^2 t.

#include "strandyn/beam/planar_element.hpp"
#include "strandyn/beam/rigid_inertia.hpp"

namespace strandyn::beam {

/// Mass of a length of beam. [kg/m], [kg m]
struct Inertia {
  double mass = 0;    ///< [kg/m] of unstressed length
  double rotary = 0;  ///< [kg m] mass moment of the section per unstressed length; 0 leaves rotary inertia out
};

/// Diagonal of the lumped mass matrix. [kg], [kg m^2]
PlanarVector lumped_mass(const PlanarElement& element, const Inertia& inertia);

/// Nodal motion of an element: positions, velocities, accelerations in the order of the unknowns.
struct PlanarMotion {
  PlanarVector q, v, a;
};

/// Consistent inertia force d/dt(dT/dv) - dT/dq. [N], [N m]
PlanarVector consistent_inertia_force(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m);

/// Its derivatives by accelerations (the mass matrix), velocities and positions, each times its factor.
PlanarMatrix consistent_inertia_tangent(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m,
                                        InertiaFactors factors);

/// Mass matrix of the consistent inertia in the position q. [kg], [kg m], [kg m^2]
PlanarMatrix consistent_mass(const PlanarElement& element, const Inertia& inertia, const PlanarVector& q);

/// [J] of the consistent inertia, at position q and velocity v.
double kinetic_energy(const PlanarElement& element, const Inertia& inertia, const PlanarVector& q,
                      const PlanarVector& v);

}  // namespace strandyn::beam
