#include "strandyn/beam/spatial_element.hpp"

#include <cmath>

#include "strandyn/math/rotation.hpp"
#include "stretch.hpp"

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

/// W, the frame's spin by the motion, 3 x 9: the chord turns it about e2 and e3, the mean of the nodes about e1. Only
/// seven of its entries are not zero, so it is never written out.
class FrameTurn {
 public:
  explicit FrameTurn(const SpatialKinematics& k) : tilt_(1 / k.chord), lean_(-k.lean / k.chord) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector3d& n = k.node[i].direction;
      roll_[i] = {n.y() / (2 * k.upright), -n.x() / (2 * k.upright)};
    }
  }

  /// K -= M W, M of as many rows as K.
  template <class Rows, class Matrix>
  void subtract_product(const Rows& M, Matrix& K) const {
    K.col(1) -= tilt_ * M.col(2);
    K.col(2) -= lean_ * M.col(0) - tilt_ * M.col(1);
    for (int i = 0; i < 2; ++i) {
      const auto [about_2, about_3] = roll_[static_cast<std::size_t>(i)];
      K.col(3 + 3 * i) -= about_2 * M.col(0);
      K.col(4 + 3 * i) -= about_3 * M.col(0);
    }
  }

 private:
  double tilt_, lean_;
  std::array<std::array<double, 2>, 2> roll_;
};

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

/// Derivative of the forces on (stretch, theta_1, theta_2) by these. With B the derivatives of (eps, chi_1, chi_2,
/// chi_3), B = [1/l0, s_1, s_2; -+1/l0 of twist; c_i of the two bendings], it is the sum of B^T C B and the tension's
/// stiffening.
LocalMatrix section_stiffness(const SpatialElement& element, const SpatialKinematics& k, double tension,
                              const SpatialSectionTangent& t) {
  const double l0 = element.length;
  const auto s = strain_slope(k);
  LocalMatrix K = LocalMatrix::Zero();
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const Eigen::Matrix4d C = gauss_weight * l0 * t.C[g];
    const auto slope = curvature_slope(g);
    Eigen::Matrix<double, 4, 7> CB;
    CB.col(0) = C.col(0) / l0;
    CB.col(4) = C.col(1) / l0;
    CB.col(1) = -CB.col(4);
    for (std::size_t i = 0; i < 2; ++i) {
      const double c = slope[i] / l0;
      const auto at = static_cast<int>(3 * i);
      CB.col(2 + at) = s[i].y() * C.col(0) + c * C.col(2);
      CB.col(3 + at) = s[i].z() * C.col(0) + c * C.col(3);
    }
    K.row(0) += CB.row(0) / l0;
    K.row(1) -= CB.row(1) / l0;
    K.row(4) += CB.row(1) / l0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double c = slope[i] / l0;
      const auto at = static_cast<int>(3 * i);
      K.row(2 + at) += s[i].y() * CB.row(0) + c * CB.row(2);
      K.row(3 + at) += s[i].z() * CB.row(0) + c * CB.row(3);
    }
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

/// The same by the stretch and the spins against the frame. Forces go back through the transpose of `from_spin`, which
/// changes with theta.
LocalMatrix spin_stiffness(const SpatialElement& element, const SpatialKinematics& k, const LocalForce& f,
                           const SpatialSectionTangent& t) {
  LocalMatrix K = section_stiffness(element, k, f.stretch, t);
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix<double, 7, 3> columns = K.middleCols<3>(1 + 3 * i);
    K.middleCols<3>(1 + 3 * i) = columns.lazyProduct(k.node[i].from_spin);
  }
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix<double, 3, 7> rows = K.middleRows<3>(1 + 3 * i);
    K.middleRows<3>(1 + 3 * i) = k.node[i].from_spin.transpose().lazyProduct(rows);
    K.block<3, 3>(1 + 3 * i, 1 + 3 * i) +=
        math::inverse_spin_map_transposed_slope(k.node[i].rotation, f.theta[i]).lazyProduct(k.node[i].from_spin);
  }
  return K;
}

/// What the change of the lever arms adds under the force held.
void add_lever_arms(const SpatialKinematics& k, const LocalForce& f, const FrameTurn& W, MotionMatrix& K) {
  const Vector3d sum = f.spin[0] + f.spin[1];
  K(1, 0) += sum.z() / (k.chord * k.chord);
  K(2, 0) -= (sum.y() + k.lean * sum.x()) / (k.chord * k.chord);

  // The directions of the nodes turn with the nodes, against the frame: n x (W - the node's spin). Their first two
  // rows; p is the mean.
  std::array<Eigen::Matrix<double, 2, 9>, 2> direction;
  for (int i = 0; i < 2; ++i) {
    const Vector3d& n = k.node[i].direction;
    Eigen::Matrix<double, 2, 3> n_cross;
    n_cross << 0, -n.z(), n.y(), n.z(), 0, -n.x();
    direction[i].setZero();
    direction[i].middleCols<3>(3 + 3 * i) = -n_cross;
    W.subtract_product(-n_cross, direction[i]);
  }
  const Eigen::Matrix<double, 2, 9> p = (direction[0] + direction[1]) / 2;
  K.row(2) += sum.x() / (k.chord * k.upright) * (p.row(0) - k.lean * p.row(1));
  const double roll = sum.x() / (2 * k.upright);
  for (int i = 0; i < 2; ++i) {
    const Vector3d& n = k.node[i].direction;
    K.row(3 + 3 * i) -= roll * (direction[i].row(1) - n.y() / k.upright * p.row(1));
    K.row(4 + 3 * i) += roll * (direction[i].row(0) - n.x() / k.upright * p.row(1));
  }
}

/// Derivative of the force on the motion by the motion, both along the frame. With E the stretch and the spins of the
/// nodes, those against the frame are E - W; S is their stiffness. The frame carries the force with it.
///     K = (E - W)^T S (E - W) + lever arms - force x W
MotionMatrix motion_stiffness(const SpatialKinematics& k, const LocalForce& f, const Motion& force,
                              const LocalMatrix& S) {
  constexpr std::array kept = {0, 3, 4, 5, 6, 7, 8};  // where E puts the rows of S
  const FrameTurn W(k);
  MotionMatrix K = MotionMatrix::Zero();
  K(kept, kept) = S;

  // -W^T (both nodes' rows of S) (E - W), through the transpose
  const Eigen::Matrix<double, 3, 7> of_nodes = S.middleRows<3>(1) + S.middleRows<3>(4);
  Eigen::Matrix<double, 3, 9> against = Eigen::Matrix<double, 3, 9>::Zero();
  against(Eigen::all, kept) = of_nodes;
  W.subtract_product(Matrix3d(of_nodes.middleCols<3>(1) + of_nodes.middleCols<3>(4)), against);
  const Eigen::Matrix<double, 9, 3> against_transposed = against.transpose();
  auto K_transposed = K.transpose();
  W.subtract_product(against_transposed, K_transposed);

  // -(E^T (both nodes' columns of S) + force x) W
  Eigen::Matrix<double, 9, 3> turned;
  for (int block : {0, 3, 6}) turned.middleRows<3>(block) = math::skew(force.segment<3>(block));
  turned(kept, Eigen::all) += S.middleCols<3>(1) + S.middleCols<3>(4);
  W.subtract_product(turned, K);
  add_lever_arms(k, f, W, K);
  return K;
}

}  // namespace

SpatialKinematics kinematics(const SpatialElement& element, const SpatialVector& q) {
  SpatialKinematics k;
  const Vector3d change = q.segment<3>(6) - q.segment<3>(0);
  const Vector3d d = element.span + change;
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
  const double stretch = stretch_of(element.span, change, l0, k.chord);
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
  const MotionMatrix K = motion_stiffness(k, f, force, spin_stiffness(element, k, f, t));

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
