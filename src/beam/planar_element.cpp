#include "strandyn/beam/planar_element.hpp"

#include <cmath>
#include <numbers>

#include "stretch.hpp"

namespace strandyn::beam {
namespace {

/// d eps/d(rotation 1, rotation 2): the slope of the mean of v'^2/2.
std::array<double, 2> strain_slope(const PlanarKinematics& k) {
  const auto [t1, t2] = k.rotation;
  return {(4 * t1 - t2) / 30, (4 * t2 - t1) / 30};
}

/// d chi/d(rotation 1, rotation 2) at Gauss point g, times the length.
std::array<double, 2> curvature_slope(std::size_t g) {
  return {6 * gauss_position[g] - 4, 6 * gauss_position[g] - 2};
}

/// Forces that work on the chord's stretch and on the two rotations in the chord's frame.
struct LocalForce {
  double stretch = 0;              ///< [N]
  std::array<double, 2> moment{};  ///< [N m]
};

LocalForce local_force(const PlanarElement& element, const PlanarKinematics& k, const PlanarResultants& r) {
  LocalForce f;
  for (double N : r.N) f.stretch += gauss_weight * N;
  const auto slope = strain_slope(k);
  for (std::size_t i = 0; i < 2; ++i) f.moment[i] = f.stretch * element.length * slope[i];
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const auto c = curvature_slope(g);
    for (std::size_t i = 0; i < 2; ++i) f.moment[i] += gauss_weight * r.M[g] * c[i];
  }
  return f;
}

}  // namespace

PlanarKinematics kinematics(const PlanarElement& element, const PlanarVector& q) {
  PlanarKinematics k;
  const Eigen::Vector2d change = q.segment<2>(3) - q.segment<2>(0);
  const Eigen::Vector2d d = element.span + change;
  k.chord = d.norm();
  k.direction = d / k.chord;
  const double alpha = std::atan2(d.y(), d.x());
  for (std::size_t i = 0; i < 2; ++i) {
    const double turn = q(i == 0 ? 2 : 5) + element.rest_angle - alpha;
    // Most elements turn little: wrapping is for those that have turned more than half a turn.
    k.rotation[i] = std::abs(turn) <= std::numbers::pi ? turn : std::remainder(turn, 2 * std::numbers::pi);
  }
  const auto [t1, t2] = k.rotation;
  const double l0 = element.length;
  const double stretch = stretch_of(element.span, change, l0, k.chord);
  k.eps = stretch / l0 + (2 * t1 * t1 - t1 * t2 + 2 * t2 * t2) / 30;
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const auto c = curvature_slope(g);
    k.chi[g] = (c[0] * t1 + c[1] * t2) / l0;
  }
  return k;
}

PlanarVector internal_force(const PlanarElement& element, const PlanarKinematics& k, const PlanarResultants& r) {
  const LocalForce f = local_force(element, k, r);
  const Eigen::Vector2d normal(-k.direction.y(), k.direction.x());
  const Eigen::Vector2d force = f.stretch * k.direction - (f.moment[0] + f.moment[1]) / k.chord * normal;
  PlanarVector out;
  out << -force, f.moment[0], force, f.moment[1];
  return out;
}

PlanarMatrix tangent(const PlanarElement& element, const PlanarKinematics& k, const PlanarResultants& r,
                     const PlanarSectionTangent& t) {
  const LocalForce f = local_force(element, k, r);
  const auto slope = strain_slope(k);
  const double l0 = element.length;
  Eigen::Matrix3d local = Eigen::Matrix3d::Zero();
  for (std::size_t g = 0; g < gauss_points; ++g) {
    const auto curve = curvature_slope(g);
    const Eigen::Vector3d eps_row(1 / l0, slope[0], slope[1]);
    const Eigen::Vector3d chi_row(0, curve[0] / l0, curve[1] / l0);
    const double w = gauss_weight * l0;
    local += w * eps_row * (t.N_eps[g] * eps_row + t.N_chi[g] * chi_row).transpose();
    local += w * chi_row * (t.M_eps[g] * eps_row + t.M_chi[g] * chi_row).transpose();
  }
  const double stiffening = f.stretch * l0 / 30;
  local(1, 1) += 4 * stiffening;
  local(2, 2) += 4 * stiffening;
  local(1, 2) -= stiffening;
  local(2, 1) -= stiffening;

  // The same by the chord's end along and across, and by the two rotations: each turns against the chord by across/l.
  const double l = k.chord;
  Eigen::Matrix4d Q;
  Q.topLeftCorner<2, 2>() << local(0, 0), (local(0, 1) + local(0, 2)) / l,  //
      (local(1, 0) + local(2, 0)) / l, local.bottomRightCorner<2, 2>().sum() / (l * l);
  Q.topRightCorner<2, 2>() << local(0, 1), local(0, 2),  //
      (local(1, 1) + local(2, 1)) / l, (local(1, 2) + local(2, 2)) / l;
  Q.bottomLeftCorner<2, 2>() << local(1, 0), (local(1, 1) + local(1, 2)) / l,  //
      local(2, 0), (local(2, 1) + local(2, 2)) / l;
  Q.bottomRightCorner<2, 2>() = local.bottomRightCorner<2, 2>();
  // What turns with the chord under the force held.
  const double turn = (f.moment[0] + f.moment[1]) / (l * l);
  Q(0, 1) -= turn;
  Q(1, 0) -= turn;
  Q(1, 1) += f.stretch / l;

  // Along and across by the displacements of node 2 less node 1: global axes.
  Eigen::Matrix2d turned;
  turned << k.direction.x(), k.direction.y(), k.direction.y(), -k.direction.x();
  const Eigen::Matrix2d ends = turned * Q.topLeftCorner<2, 2>() * turned;
  const Eigen::Matrix2d columns = turned * Q.topRightCorner<2, 2>();
  const Eigen::Matrix2d rows = Q.bottomLeftCorner<2, 2>() * turned;
  PlanarMatrix K;
  for (int i = 0; i < 2; ++i) {
    const double row_sign = i == 0 ? -1 : 1;
    for (int j = 0; j < 2; ++j) {
      const double column_sign = j == 0 ? -1 : 1;
      K.block<2, 2>(3 * i, 3 * j) = row_sign * column_sign * ends;
      K.block<2, 1>(3 * i, 3 * j + 2) = row_sign * columns.col(j);
      K.block<1, 2>(3 * i + 2, 3 * j) = column_sign * rows.row(i);
      K(3 * i + 2, 3 * j + 2) = Q(2 + i, 2 + j);
    }
  }
  return K;
}

}  // namespace strandyn::beam
