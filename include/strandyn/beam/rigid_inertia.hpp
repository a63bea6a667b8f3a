#pragma once
/// \file Rotary inertia of a rigid body that is fixed to a node and turns with its total rotation vector psi.
///
/// Seen from the body, which turns by R = Exp(psi) with the map T of spins (spatial angular velocity w = T psi'):
///     W = R^T w = T^T psi',    A = W' = T^T psi'' + (T^T)' psi',    kinetic energy W . J W/2
///     force on psi = T (J A + W x J W)      (the same as T^T (J_s alpha + w x J_s w) in space, J_s = R J R^T)
/// It is Lagrange's force of the energy. The body's centre of mass is the node, so its mass adds mass * acceleration.

#include <Eigen/Dense>

namespace strandyn::beam {

struct RigidInertia {
  double mass = 0;                                   ///< [kg]
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();  ///< [kg m^2] about the node, in the axes of the reference
};

/// How much of each derivative of an inertia force a matrix takes.
struct InertiaFactors {
  double acceleration = 0;  ///< of the mass matrix
  double velocity = 0;      ///< of the derivative by velocities
  double position = 0;      ///< of that by positions
};

/// Motion of the total rotation vector. |psi| stays below a full turn, where T has no inverse.
struct RotationMotion {
  Eigen::Vector3d psi;           ///< [rad]
  Eigen::Vector3d rate;          ///< [rad/s] psi'
  Eigen::Vector3d acceleration;  ///< [rad/s^2] psi''
};

/// Generalized inertia force on psi. [N m]
Eigen::Vector3d rotary_force(const RigidInertia& body, const RotationMotion& m);

/// Its derivatives with respect to psi'' (the mass matrix), psi' and psi.
struct RotaryTangent {
  Eigen::Matrix3d mass, velocity, position;
};
RotaryTangent rotary_tangent(const RigidInertia& body, const RotationMotion& m);

/// Mass matrix T J T^T of the rotation in the position psi. [kg m^2]
Eigen::Matrix3d rotary_mass(const RigidInertia& body, const Eigen::Vector3d& psi);

}  // namespace strandyn::beam
