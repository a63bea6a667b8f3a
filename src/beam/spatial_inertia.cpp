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

/// Columns of the translations, for the derivatives `row` of the tangents.
void couple_translations(SpatialMatrix& m, const Eigen::Matrix4d& table, const TwoMatrices& row) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      m.block<3, 3>(6 * i, 6 * j) = table(2 * i, 2 * j) * Eigen::Matrix3d::Identity();
      m.block<3, 3>(6 * i + 3, 6 * j) = table(2 * i + 1, 2 * j) * row[static_cast<std::size_t>(i)].transpose();
    }
  }
}

}  // namespace

RigidInertia nodal_inertia(const SpatialElement& element, const SpatialSectionInertia& inertia) {
  const double half = element.length / 2;
  const Eigen::Vector3d principal(inertia.polar, inertia.rotary, inertia.rotary);
  return {.mass = half * inertia.mass,
          .moment = half * element.triad * principal.asDiagonal() * element.triad.transpose()};
}

SpatialMatrix consistent_mass(const SpatialElement& element, double mass, const SpatialVector& q) {
  const Eigen::Matrix4d table = mass * hermite_table(element.length);
  const Eigen::Vector3d a = element.triad.col(0);
  TwoMatrices by_psi;
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyTurn turn(q.segment<3>(i == 0 ? 3 : 9));
    by_psi[i].noalias() = -turn.rotation() * math::crossed(a, turn.spin_map());
  }
  SpatialMatrix m;
  couple_rotations(m, table, by_psi, by_psi);
  couple_translations(m, table, by_psi);
  return m;
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

SpatialMatrix consistent_inertia_tangent(const SpatialElement& element, double mass, const SpatialMotion& m,
                                         InertiaFactors factors) {
  const Eigen::Matrix4d table = mass * hermite_table(element.length);
  const Eigen::Vector3d a = element.triad.col(0);
  const TwoTurns turn = turns(m.q);

  TwoMatrices S, by_psi;  // dt/dpsi
  TwoMatrices changes;    // of t'', by all three in their parts
  std::array<Eigen::Vector3d, 2> acceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotationMotion motion = rotation(m, static_cast<int>(i));
    const BodySpin spin = body_spin(turn[i], motion);
    const BodySpinTangent t = body_spin_tangent(turn[i], motion, spin);
    const Eigen::Matrix3d R = turn[i].rotation();
    const Eigen::Vector3d carried = carried_acceleration(spin, a);
    const Eigen::Matrix3d W_part = factors.velocity * t.S + factors.position * t.W_psi;
    const Eigen::Matrix3d A_part =
        factors.acceleration * t.S + factors.velocity * t.A_rate + factors.position * t.A_psi;
    // The derivative of W x (W x a) is (W . a) dW - a (W . dW) - (W x a) x dW.
    Eigen::Matrix3d in_body = spin.W.dot(a) * W_part - math::crossed(spin.W.cross(a), W_part) -
                              math::crossed(a, A_part) - factors.position * math::crossed(carried, t.S);
    in_body -= a * (spin.W.transpose() * W_part).eval();
    S[i] = t.S;
    acceleration[i] = R * carried;
    by_psi[i].noalias() = -R * math::crossed(a, t.S);
    changes[i].noalias() = R * in_body;
  }

  SpatialMatrix tangent;
  couple_rotations(tangent, table, by_psi, changes);
  couple_translations(tangent, factors.acceleration * table, by_psi);
  if (factors.position == 0) return tangent;
  // The direction that the force on psi is taken along turns as well.
  const FourVectors P = momentum_rate(table, m, acceleration);
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d along = turn[at].to_body(P.col(2 * i + 1));
    const Eigen::Vector3d S_along = S[at].transpose() * along;
    const Eigen::Matrix3d turned = S_along * (a.transpose() * S[at]).eval() - a.dot(along) * S[at].transpose() * S[at];
    tangent.block<3, 3>(6 * i + 3, 6 * i + 3) +=
        factors.position * (turn[at].spin_transposed_slope(a.cross(along)) + turned);
  }
  return tangent;
}

}  // namespace strandyn::beam
