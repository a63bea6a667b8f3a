#include "strandyn/beam/spatial_inertia.hpp"

#include <array>

#include "body_spin.hpp"
#include "hermite_table.hpp"

namespace strandyn::beam {
namespace {

using TwoTurns = std::array<BodyTurn, 2>;
using TwoMatrices = std::array<Eigen::Matrix3d, 2>;
using FourVectors = Eigen::Matrix<double, 3, 4>;  // one column for each of x_1, t_1, x_2, t_2

TwoTurns turns(const SpatialVector& q) {
  return {BodyTurn(q.segment<3>(3)), BodyTurn(q.segment<3>(9))};
}

/// Rotation of node 0 or 1.
RotationMotion rotation(const SpatialMotion& m, int node) {
  const int at = 6 * node + 3;
  return {.psi = m.q.segment<3>(at), .rate = m.v.segment<3>(at), .acceleration = m.a.segment<3>(at)};
}

/// R^T t'' of a tangent t = R a, with a fixed in the turning frame.
Eigen::Vector3d carried_acceleration(const BodySpin& spin, const Eigen::Vector3d& a) {
  return spin.A.cross(a) + spin.W.cross(spin.W.cross(a));
}

/// The table times the second time derivative of (x_1, t_1, x_2, t_2).
FourVectors momentum_rate(const Eigen::Matrix4d& table, const SpatialMotion& m,
                          const std::array<Eigen::Vector3d, 2>& tangent_acceleration) {
  FourVectors X;
  X << m.a.segment<3>(0), tangent_acceleration[0], m.a.segment<3>(6), tangent_acceleration[1];
  return X * table;  // the table is symmetric
}

/// Columns of the rotations: derivatives of t'' (or of t), with `row` taken along dt/dpsi.
void couple_rotations(SpatialMatrix& m, const Eigen::Matrix4d& table, const TwoMatrices& row,
                      const TwoMatrices& column) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const auto ri = static_cast<std::size_t>(i);
      const auto cj = static_cast<std::size_t>(j);
      m.block<3, 3>(6 * i, 6 * j + 3) = table(2 * i, 2 * j + 1) * column[cj];
      m.block<3, 3>(6 * i + 3, 6 * j + 3) = table(2 * i + 1, 2 * j + 1) * row[ri].transpose() * column[cj];
    }
  }
}

/// G^T m G for the derivatives `by_psi` of the tangents.
SpatialMatrix mass_matrix(const Eigen::Matrix4d& table, const TwoMatrices& by_psi) {
  SpatialMatrix m;
  couple_rotations(m, table, by_psi, by_psi);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      m.block<3, 3>(6 * i, 6 * j) = table(2 * i, 2 * j) * Eigen::Matrix3d::Identity();
      m.block<3, 3>(6 * i + 3, 6 * j) = table(2 * i + 1, 2 * j) * by_psi[static_cast<std::size_t>(i)].transpose();
    }
  }
  return m;
}

}  // namespace

RigidInertia nodal_inertia(const SpatialElement& element, const SpatialSectionInertia& inertia) {
  const double half = element.length / 2;
  const Eigen::Vector3d principal(inertia.polar, inertia.rotary, inertia.rotary);
  return {.mass = half * inertia.mass,
          .moment = half * element.triad * principal.asDiagonal() * element.triad.transpose()};
}

SpatialMatrix consistent_mass(const SpatialElement& element, double mass, const SpatialVector& q) {
  const Eigen::Matrix3d a_cross = math::skew(element.triad.col(0));
  TwoMatrices by_psi;
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyTurn turn(q.segment<3>(i == 0 ? 3 : 9));
    by_psi[i] = -turn.rotation() * a_cross * turn.spin_map();
  }
  return mass_matrix(mass * hermite_table(element.length), by_psi);
}

SpatialVector consistent_inertia_force(const SpatialElement& element, double mass, const SpatialMotion& m) {
  const Eigen::Vector3d a = element.triad.col(0);
  const TwoTurns turn = turns(m.q);
  std::array<Eigen::Vector3d, 2> acceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    const BodySpin spin = body_spin(turn[i], rotation(m, static_cast<int>(i)));
    acceleration[i] = turn[i].to_space(carried_acceleration(spin, a));
  }
  const FourVectors P = momentum_rate(mass * hermite_table(element.length), m, acceleration);
  SpatialVector force;
  for (int i = 0; i < 2; ++i) {
    const BodyTurn& at = turn[static_cast<std::size_t>(i)];
    force.segment<3>(6 * i) = P.col(2 * i);
    force.segment<3>(6 * i + 3) = at.spin_transposed(a.cross(at.to_body(P.col(2 * i + 1))));
  }
  return force;
}

SpatialInertiaTangent consistent_inertia_tangent(const SpatialElement& element, double mass, const SpatialMotion& m) {
  const Eigen::Matrix4d table = mass * hermite_table(element.length);
  const Eigen::Vector3d a = element.triad.col(0);
  const Eigen::Matrix3d a_cross = math::skew(a);
  const TwoTurns turn = turns(m.q);

  TwoMatrices S, by_psi;                 // dt/dpsi, and so dt''/dpsi''
  TwoMatrices by_velocity, by_position;  // of t''
  std::array<Eigen::Vector3d, 2> acceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotationMotion motion = rotation(m, static_cast<int>(i));
    const BodySpin spin = body_spin(turn[i], motion);
    const BodySpinTangent t = body_spin_tangent(turn[i], motion, spin);
    const Eigen::Matrix3d R = turn[i].rotation();
    const Eigen::Vector3d carried = carried_acceleration(spin, a);
    const Eigen::Matrix3d by_W =
        -math::skew(spin.W.cross(a)) - math::skew(spin.W) * a_cross;  // derivative of W x (W x a)
    S[i] = t.S;
    acceleration[i] = R * carried;
    by_psi[i] = -R * a_cross * t.S;
    by_velocity[i] = R * (by_W * t.S - a_cross * t.A_rate);
    by_position[i] = R * (by_W * t.W_psi - a_cross * t.A_psi - math::skew(carried) * t.S);
  }
  const FourVectors P = momentum_rate(table, m, acceleration);

  SpatialInertiaTangent tangent{
      .mass = mass_matrix(table, by_psi), .velocity = SpatialMatrix::Zero(), .position = SpatialMatrix::Zero()};
  couple_rotations(tangent.velocity, table, by_psi, by_velocity);
  couple_rotations(tangent.position, table, by_psi, by_position);
  // The direction that the force on psi is taken along turns as well.
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d along = turn[at].to_body(P.col(2 * i + 1));
    tangent.position.block<3, 3>(6 * i + 3, 6 * i + 3) +=
        turn[at].spin_transposed_slope(a.cross(along)) + S[at].transpose() * a_cross * math::skew(along) * S[at];
  }
  return tangent;
}

}  // namespace strandyn::beam
