#include "strandyn/beam/rigid_inertia.hpp"

#include "body_spin.hpp"

namespace strandyn::beam {

Eigen::Vector3d rotary_force(const RigidInertia& body, const RotationMotion& m) {
  const BodyTurn turn(m.psi);
  const auto [W, A] = body_spin(turn, m);
  return turn.spin_transposed(body.moment * A + W.cross(body.moment * W));
}

RotaryTangent rotary_tangent(const RigidInertia& body, const RotationMotion& m) {
  const BodyTurn turn(m.psi);
  const BodySpin spin = body_spin(turn, m);
  const BodySpinTangent t = body_spin_tangent(turn, m, spin);
  const Eigen::Matrix3d& J = body.moment;
  const Eigen::Vector3d momentum = J * spin.W;
  const Eigen::Vector3d torque = J * spin.A + spin.W.cross(momentum);
  const Eigen::Matrix3d torque_W = math::skew(spin.W) * J - math::skew(momentum);  // derivative of W x J W
  return {.mass = t.S.transpose() * J * t.S,
          .velocity = t.S.transpose() * (J * t.A_rate + torque_W * t.S),
          .position = t.S.transpose() * (J * t.A_psi + torque_W * t.W_psi) + turn.spin_transposed_slope(torque)};
}

Eigen::Matrix3d rotary_mass(const RigidInertia& body, const Eigen::Vector3d& psi) {
  const Eigen::Matrix3d S = BodyTurn(psi).spin_map();
  return S.transpose() * body.moment * S;
}

}  // namespace strandyn::beam
