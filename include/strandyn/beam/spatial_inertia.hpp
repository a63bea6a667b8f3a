#pragma once
/// \file Consistent inertia of the spatial element, and its sections' rotary inertia lumped at the nodes.
///
/// The centre line is the Hermite curve through the nodes with the tangents t_i = Exp(psi_i) a, a the axis of the
/// unbent element. With the table m_ab of the planar element and X = (x_1, t_1, x_2, t_2):
///     T = 1/2 sum m_ab X_a' . X_b',   force = G^T m X'',   G = dX/dq,   X'' = G q'' + G' q'
/// The kinetic energy is objective for any rotation and the force is Lagrange's of it, centrifugal terms included. In
/// a plane it is the planar element's. A spin about the axis moves no centre line: its energy is the rotary inertia's,
/// a rigid body at each node, less a part that makes it the mean of lumped and linear twist,
///     T = J_p l/2 [5/12 (w_1^2 + w_2^2) + w_1 w_2/6] = J_p l/4 (w_1^2 + w_2^2) - J_p l/24 (w_2 - w_1)^2,   w_i = a .
///     W_i
/// with W the spins seen from the sections. Torsional frequencies of either alone are off by (k l)^2/24, those of the
/// mean by (k l)^4/480 [Goudreau & Taylor 1972].

#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/beam/spatial_element.hpp"

namespace strandyn::beam {

/// Inertia of a length of beam in space, per unstressed length.
struct SpatialSectionInertia {
  double mass = 0;    ///< [kg/m]
  double rotary = 0;  ///< [kg m] about each axis of bending
  double polar = 0;   ///< [kg m] about the axis of the beam
};

/// What each of the two nodes carries of an element as a rigid body: half of its mass and of its sections.
RigidInertia nodal_inertia(const SpatialElement& element, const SpatialSectionInertia& inertia);

/// Nodal motion of an element: unknowns and their first and second time derivatives, in the order of the unknowns.
struct SpatialMotion {
  SpatialVector q, v, a;
};

/// Consistent inertia force d/dt(dT/dv) - dT/dq of the mass, and of what the polar inertia has beside that lumped at
/// the nodes. [N], [N m]
SpatialVector consistent_inertia_force(const SpatialElement& element, const SpatialSectionInertia& inertia,
                                       const SpatialMotion& m);

/// Its derivatives with respect to accelerations (the mass matrix), velocities and positions, each times its factor.
SpatialMatrix consistent_inertia_tangent(const SpatialElement& element, const SpatialSectionInertia& inertia,
                                         const SpatialMotion& m, InertiaFactors factors);

/// Mass matrix of the consistent inertia in the position q. [kg], [kg m], [kg m^2]
SpatialMatrix consistent_mass(const SpatialElement& element, const SpatialSectionInertia& inertia,
                              const SpatialVector& q);

}  // namespace strandyn::beam
