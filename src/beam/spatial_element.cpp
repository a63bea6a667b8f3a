#include "strandyn/beam/spatial_element.hpp"

#include <cmath>

#include "strandyn/math/rotation.hpp"

namespace strandyn::beam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Two sets of coordinates between the nodes and the section, both with axes along the frame:
//   strains and forces  (stretch, theta_1, theta_2)                       7
//   motions             (change of the chord, spin of node 1, of node 2)  9
using Local = Eigen::Matrix<double, 7, 1>;
using LocalMatrix = Eigen::Matrix<double, 7, 7>;
using Motion = Eigen::Matrix<double, 9, 1>;
using MotionMatrix = Eigen::Matrix<double, 9, 9>;
using Turn = Eigen::Matrix<double, 3, 9>;
using LocalFromMotion = Eigen::Matrix<double, 7, 9>;

/// d chi_k/d(theta_1k, theta_2k) at Gauss point g, times the length.
std::array<double, 2> curvature_slope(std::size_t g) {
  return {6 * gauss_position[g] - 4, 6 * gauss_position[g] - 2};
}

/// d eps/d(theta_1, theta_2): the slope of the mean of (v'^2 + w'^2)/2.
std::array<Vector3d, 2> strain_slope(const SpatialKinematics& k) {
  const Vector3d& a = k.node[0].rotation;
  const Vector3d& b = k.node[1].rotation;
  return {Vector3d(0, (4 * a.y() - b.y()) / 30, (4 * a.z() - b.z()) / 30),
          Vector3d(0, (4 * b.y() - a.y()) / 30, (4 * b.z() - a.z()) / 30)};
}

/// What works on the chord's stretch and, node by node, on theta_i or on the spin against the frame.
struct LocalForce {
  double stretch = 0;             ///< [N]
  std::array<Vector3d, 2> theta;  ///< [N m] works on dtheta_i
  std::array<Vector3d, 2> spin;   ///< [N m] works on the spin
};

LocalForce local_force(const SpatialElement& element, const SpatialKinematics& k, const SpatialResultants& r) {
  LocalForce f;
  double torque = 0;
  for (std::size_t g = 0; g < gauss_points; ++g) {
    f.stretch += gauss_weight * r.N[g];
    torque += gauss_weight * r.M1[g];
  }
  const auto slope = strain_slope(k);
  for (std::size_t i = 0; i < 2; ++i) {
    f.theta[i] = f.stretch * element.length * slope[i];
    f.theta[i].x() = i == 0 ? -torque : torque;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      const double c = gauss_weight * curvature_slope(g)[i];
      f.theta[i].y() += c * r.M2[g];
      f.theta[i].z() += c * r.M3[g];
    }
    f.spin[i] = k.node[i].from_spin.transpose() * f.theta[i];
  }
  return f;
}

/// The frame's spin by the motion: the chord turns it about e2 and e3, the mean of the nodes about e1.
Turn frame_turn(const SpatialKinematics& k) {
  Turn W = Turn::Zero();
  W(0, 2) = -k.lean / k.chord;
  for (int i = 0; i < 2; ++i) {
    const Vector3d& n = k.node[i].direction;
    W(0, 3 + 3 * i) = n.y() / (2 * k.upright);
    W(0, 4 + 3 * i) = -n.x() / (2 * k.upright);
  }
  W(1, 2) = -1 / k.chord;
  W(2, 1) = 1 / k.chord;
  return W;
}

/// The force that works on the motion: on the chord's change, and on the spins of the nodes.
Motion motion_force(const SpatialKinematics& k, const LocalForce& f) {
  const Vector3d sum = f.spin[0] + f.spin[1];
  const double roll = sum.x() / (2 * k.upright);
  Motion out;
  out.head<3>() << f.stretch, -sum.z() / k.chord, (sum.y() + k.lean * sum.x()) / k.chord;
  for (int i = 0; i < 2; ++i) {
    const Vector3d& n = k.node[i].direction;
    out.segment<3>(3 + 3 * i) = f.spin[i] - roll * Vector3d(n.y(), -n.x(), 0);
  }
  return out;
}

/// Derivative of (stretch, theta_1, theta_2) forces by (stretch, theta_1, theta_2).
LocalMatrix section_stiffness(const SpatialElement& element, const SpatialKinematics& k, double tension,
                              const SpatialSectionTangent& t) {
  const double l0 = element.length;
  const auto slope = strain_slope(k);
  Eigen::Matrix<double, 4, 7> B = Eigen::Matrix<double, 4, 7>::Zero();
  B.row(0) << 1 / l0, slope[0].transpose(), slope[1].transpose();
  B(1, 1) = -1 / l0;
  B(1, 4) = 1 / l0;
  LocalMatrix K = LocalMatrix::Zero();
  for (std::size_t g = 0; g < gauss_points; ++g) {
    for (int i = 0; i < 2; ++i) {
      const double c = curvature_slope(g)[i] / l0;
      B(2, 2 + 3 * i) = c;
      B(3, 3 + 3 * i) = c;
    }
    const Eigen::Matrix<double, 4, 7> CB = gauss_weight * l0 * t.C[g] * B;
    K.noalias() += B.transpose() * CB;
  }
  const double stiffening = tension * l0 / 30;
  for (int axis : {2, 3}) {
    K(axis, axis) += 4 * stiffening;
    K(axis + 3, axis + 3) += 4 * stiffening;
    K(axis, axis + 3) -= stiffening;
    K(axis + 3, axis) -= stiffening;
  }
  return K;
}

/// What the change of geometry adds under the force held: of the lever arms, and of the frame that carries the force.
MotionMatrix geometric_stiffness(const SpatialKinematics& k, const LocalForce& f, const Motion& force, const Turn& W) {
  MotionMatrix K = MotionMatrix::Zero();
  const Vector3d sum = f.spin[0] + f.spin[1];
  K(1, 0) = sum.z() / (k.chord * k.chord);
  K(2, 0) = -(sum.y() + k.lean * sum.x()) / (k.chord * k.chord);

  // The directions of the nodes turn with the nodes, against the frame; p is their mean.
  std::array<Turn, 2> direction;
  for (int i = 0; i < 2; ++i) {
    const Matrix3d n = math::skew(k.node[i].direction);
    direction[i].noalias() = n * W;
    direction[i].middleCols<3>(3 + 3 * i) -= n;
  }
  const Eigen::Matrix<double, 2, 9> p = (direction[0] + direction[1]).topRows<2>() / 2;
  K.row(2) += sum.x() / (k.chord * k.upright) * (p.row(0) - k.lean * p.row(1));
  const double roll = sum.x() / (2 * k.upright);
  for (int i = 0; i < 2; ++i) {
    const Vector3d& n = k.node[i].direction;
    K.row(3 + 3 * i) -= roll * (direction[i].row(1) - n.y() / k.upright * p.row(1));
    K.row(4 + 3 * i) += roll * (direction[i].row(0) - n.x() / k.upright * p.row(1));
  }
  for (int block : {0, 3, 6}) K.middleRows<3>(block).noalias() -= math::skew(force.segment<3>(block)) * W;
  return K;
}

}  // namespace

SpatialKinematics kinematics(const SpatialElement& element, const SpatialVector& q) {
  SpatialKinematics k;
  const Vector3d d = element.span + q.segment<3>(6) - q.segment<3>(0);
  k.chord = d.norm();
  std::array<Matrix3d, 2> axes;
  for (std::size_t i = 0; i < 2; ++i) {
    k.node[i].psi = q.segment<3>(i == 0 ? 3 : 9);
    axes[i].noalias() = math::rotation(k.node[i].psi) * element.triad;
    k.node[i].spin_map = math::spin_map(k.node[i].psi);
  }
  const Vector3d e1 = d / k.chord;
  const Vector3d p = (axes[0].col(1) + axes[1].col(1)) / 2;
  const Vector3d across = e1.cross(p);
  k.upright = across.norm();
  k.lean = e1.dot(p) / k.upright;
  const Vector3d e3 = across / k.upright;
  k.frame << e1, e3.cross(e1), e3;
  for (std::size_t i = 0; i < 2; ++i) {
    const Matrix3d local = k.frame.transpose() * axes[i];
    k.node[i].rotation = math::rotation_vector(local);
    k.node[i].from_spin = math::inverse_spin_map(k.node[i].rotation);
    k.node[i].direction = local.col(1);
  }

  const Vector3d& a = k.node[0].rotation;
  const Vector3d& b = k.node[1].rotation;
  const double l0 = element.length;
  const double stretch = (d.squaredNorm() - l0 * l0) / (k.chord + l0);
  k.eps = stretch / l0;
  for (int axis : {1, 2}) k.eps += (2 * a(axis) * a(axis) - a(axis) * b(axis) + 2 * b(axis) * b(axis)) / 30;
  k.chi1 = (b.x() - a.x()) / l0;
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const auto c = curvature_slope(g);
    k.chi2[g] = (c[0] * a.y() + c[1] * b.y()) / l0;
    k.chi3[g] = (c[0] * a.z() + c[1] * b.z()) / l0;
  }
  return k;
}

SpatialVector internal_force(const SpatialElement& element, const SpatialKinematics& k, const SpatialResultants& r) {
  const Motion force = motion_force(k, local_force(element, k, r));
  SpatialVector out;
  out.segment<3>(6) = k.frame * force.head<3>();
  out.segment<3>(0) = -out.segment<3>(6);
  for (int i = 0; i < 2; ++i) {
    const Vector3d moment = k.frame * force.segment<3>(3 + 3 * i);
    out.segment<3>(3 + 6 * i) = k.node[i].spin_map.transpose() * moment;
  }
  return out;
}

SpatialMatrix tangent(const SpatialElement& element, const SpatialKinematics& k, const SpatialResultants& r,
                      const SpatialSectionTangent& t) {
  const LocalForce f = local_force(element, k, r);
  const Motion force = motion_force(k, f);
  const Turn W = frame_turn(k);

  // A: the stretch and the changes of theta_i by the motion. Forces go back through its transpose; theta's map changes
  // with theta.
  LocalFromMotion A = LocalFromMotion::Zero();
  A(0, 0) = 1;
  LocalFromMotion spins = A;
  std::array<Matrix3d, 2> bent;
  for (int i = 0; i < 2; ++i) {
    Turn spin = -W;
    spin.middleCols<3>(3 + 3 * i).diagonal().array() += 1;
    spins.middleRows<3>(1 + 3 * i) = spin;
    A.middleRows<3>(1 + 3 * i).noalias() = k.node[i].from_spin * spin;
    bent[i] = math::inverse_spin_map_transposed_slope(k.node[i].rotation, f.theta[i]);
  }
  const LocalFromMotion theta_force = section_stiffness(element, k, f.stretch, t) * A;
  LocalFromMotion spin_force;
  spin_force.row(0) = theta_force.row(0);
  for (int i = 0; i < 2; ++i) {
    const int rows = 1 + 3 * i;
    spin_force.middleRows<3>(rows).noalias() = k.node[i].from_spin.transpose() * theta_force.middleRows<3>(rows);
    spin_force.middleRows<3>(rows).noalias() += bent[i] * A.middleRows<3>(rows);
  }
  MotionMatrix K = geometric_stiffness(k, f, force, W);
  K.noalias() += spins.transpose() * spin_force;

  // From the frame's axes to global ones, from spins to rotation vectors.
  const std::array<Matrix3d, 3> out = {k.frame.transpose(), k.frame.transpose() * k.node[0].spin_map,
                                       k.frame.transpose() * k.node[1].spin_map};
  std::array<std::array<Matrix3d, 3>, 3> block;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Matrix3d right = K.block<3, 3>(3 * i, 3 * j) * out[j];
      block[i][j].noalias() = out[i].transpose() * right;
    }
  }
  for (int i = 0; i < 2; ++i) {
    block[1 + i][1 + i] += math::spin_map_transposed_slope(k.node[i].psi, k.frame * force.segment<3>(3 + 3 * i));
  }
  SpatialMatrix out12;
  out12 << block[0][0], -block[0][1], -block[0][0], -block[0][2],  //
      -block[1][0], block[1][1], block[1][0], block[1][2],         //
      -block[0][0], block[0][1], block[0][0], block[0][2],         //
      -block[2][0], block[2][1], block[2][0], block[2][2];
  return out12;
}

}  // namespace strandyn::beam
