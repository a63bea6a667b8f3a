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

/// What the mean of a linear twist takes from the lumped polar inertia: the energy -c/2 (a . W_2 - a . W_1)^2.
struct TwistCorrection {
  double c = 0;  // [kg m^2]
  Eigen::Vector3d a;
  double difference = 0;       // [rad/s] a . (W_2 - W_1)
  double difference_rate = 0;  // [rad/s^2]

  static constexpr std::array<double, 2> sign = {-1, 1};

  TwistCorrection(const SpatialElement& element, double polar)
      : c(polar * element.length / 12), a(element.triad.col(0)) {}
  void see(const std::array<BodySpin, 2>& spin) {
    difference = a.dot(spin[1].W - spin[0].W);
    difference_rate = a.dot(spin[1].A - spin[0].A);
  }
  /// Of the body at node i: d(h a)/dt + W x h a with h = dT/d(a . W_i).
  Eigen::Vector3d torque(std::size_t i, const BodySpin& spin) const {
    return -c * sign[i] * (difference_rate * a + difference * spin.W.cross(a));
  }
  /// Its change with the body at node j, which changes W_j and A_j.
  Eigen::Matrix3d torque_change(std::size_t i, std::size_t j, const BodySpin& spin, const Eigen::Matrix3d& W_part,
                                const Eigen::Matrix3d& A_part) const {
    Eigen::Matrix3d change = sign[j] * (a * (a.transpose() * A_part) + spin.W.cross(a) * (a.transpose() * W_part));
    if (i == j) change -= difference * math::crossed(a, W_part);
    return -c * sign[i] * change;
  }
};

}  // namespace

RigidInertia nodal_inertia(const SpatialElement& element, const SpatialSectionInertia& inertia) {
  const double half = element.length / 2;
  const Eigen::Vector3d principal(inertia.polar, inertia.rotary, inertia.rotary);
  return {.mass = half * inertia.mass,
          .moment = half * element.triad * principal.asDiagonal() * element.triad.transpose()};
}

SpatialMatrix consistent_mass(const SpatialElement& element, const SpatialSectionInertia& inertia,
                              const SpatialVector& q) {
  const Eigen::Matrix4d table = hermite_table(inertia.mass, element.length);
  const TwistCorrection twist(element, inertia.polar);
  const Eigen::Vector3d& a = twist.a;
  TwoMatrices by_psi;
  SpatialVector spin_by_rate = SpatialVector::Zero();  // of a . (W_2 - W_1)
  for (std::size_t i = 0; i < 2; ++i) {
    const int at = i == 0 ? 3 : 9;
    const BodyTurn turn(q.segment<3>(at));
    by_psi[i].noalias() = -turn.rotation() * math::crossed(a, turn.spin_map());
    spin_by_rate.segment<3>(at) = TwistCorrection::sign[i] * turn.spin_transposed(a);
  }
  SpatialMatrix m;
  couple_rotations(m, table, by_psi, by_psi);
  couple_translations(m, table, by_psi);
  if (twist.c != 0) m.noalias() -= twist.c * spin_by_rate * spin_by_rate.transpose();
  return m;
}

SpatialVector consistent_inertia_force(const SpatialElement& element, const SpatialSectionInertia& inertia,
                                       const SpatialMotion& m) {
  TwistCorrection twist(element, inertia.polar);
  const Eigen::Vector3d& a = twist.a;
  const TwoTurns turn = turns(m.q);
  std::array<BodySpin, 2> spin;
  std::array<Eigen::Vector3d, 2> acceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    spin[i] = body_spin(turn[i], rotation(m, static_cast<int>(i)));
    acceleration[i] = turn[i].to_space(carried_acceleration(spin[i], a));
  }
  twist.see(spin);
  const FourVectors P = momentum_rate(hermite_table(inertia.mass, element.length), m, acceleration);
  SpatialVector force;
  for (int i = 0; i < 2; ++i) {
    const auto node = static_cast<std::size_t>(i);
    const BodyTurn& at = turn[node];
    Eigen::Vector3d torque = a.cross(at.to_body(P.col(2 * i + 1)));
    if (twist.c != 0) torque += twist.torque(node, spin[node]);
    force.segment<3>(6 * i) = P.col(2 * i);
    force.segment<3>(6 * i + 3) = at.spin_transposed(torque);
  }
  return force;
}

SpatialMatrix consistent_inertia_tangent(const SpatialElement& element, const SpatialSectionInertia& inertia,
                                         const SpatialMotion& m, InertiaFactors factors) {
  const Eigen::Matrix4d table = hermite_table(inertia.mass, element.length);
  TwistCorrection twist(element, inertia.polar);
  const Eigen::Vector3d& a = twist.a;
  const TwoTurns turn = turns(m.q);

  TwoMatrices S, by_psi;  // dt/dpsi
  TwoMatrices changes;    // of t'', by all three in their parts
  TwoMatrices W_part, A_part;
  std::array<BodySpin, 2> spin;
  std::array<Eigen::Vector3d, 2> acceleration;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotationMotion motion = rotation(m, static_cast<int>(i));
    spin[i] = body_spin(turn[i], motion);
    const Eigen::Vector3d& W = spin[i].W;
    const BodySpinTangent t = body_spin_tangent(turn[i], motion, spin[i]);
    const Eigen::Matrix3d R = turn[i].rotation();
    const Eigen::Vector3d carried = carried_acceleration(spin[i], a);
    W_part[i] = factors.velocity * t.S + factors.position * t.W_psi;
    A_part[i] = factors.acceleration * t.S + factors.velocity * t.A_rate + factors.position * t.A_psi;
    // The derivative of W x (W x a) is (W . a) dW - a (W . dW) - (W x a) x dW.
    Eigen::Matrix3d in_body = W.dot(a) * W_part[i] - math::crossed(W.cross(a), W_part[i]) -
                              math::crossed(a, A_part[i]) - factors.position * math::crossed(carried, t.S);
    in_body -= a * (W.transpose() * W_part[i]).eval();
    S[i] = t.S;
    acceleration[i] = R * carried;
    by_psi[i].noalias() = -R * math::crossed(a, t.S);
    changes[i].noalias() = R * in_body;
  }

  SpatialMatrix tangent;
  couple_rotations(tangent, table, by_psi, changes);
  couple_translations(tangent, factors.acceleration * table, by_psi);
  if (twist.c != 0) {
    twist.see(spin);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto row = static_cast<Eigen::Index>(6 * i + 3);
      for (std::size_t j = 0; j < 2; ++j) {
        tangent.block<3, 3>(row, static_cast<Eigen::Index>(6 * j + 3)).noalias() +=
            S[i].transpose() * twist.torque_change(i, j, spin[i], W_part[j], A_part[j]);
      }
      if (factors.position == 0) continue;
      tangent.block<3, 3>(row, row) += factors.position * turn[i].spin_transposed_slope(twist.torque(i, spin[i]));
    }
  }
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
