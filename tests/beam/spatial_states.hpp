#pragma once
/// \file Elements, nodal states and sections for tests of the spatial element.

#include <random>

#include "strandyn/beam/spatial_element.hpp"
#include "strandyn/math/rotation.hpp"

namespace strandyn::test {

/// (eps, chi1, chi2, chi3) at Gauss point g.
inline Eigen::Vector4d strain(const beam::SpatialKinematics& k, std::size_t g) {
  return {k.eps, k.chi1, k.chi2[g], k.chi3[g]};
}

/// A section with every coupling, and with resultants where it is not strained.
struct LinearSection {
  std::array<Eigen::Matrix4d, beam::gauss_points> C;
  std::array<Eigen::Vector4d, beam::gauss_points> offset = {Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};

  beam::SpatialResultants operator()(const beam::SpatialKinematics& k) const {
    beam::SpatialResultants r;
    for (std::size_t g = 0; g < beam::gauss_points; ++g) {
      const Eigen::Vector4d s = offset[g] + C[g] * strain(k, g);
      r.N[g] = s(0);
      r.M1[g] = s(1);
      r.M2[g] = s(2);
      r.M3[g] = s(3);
    }
    return r;
  }
};

/// A wire rope's stiffness in SI units, the same about both axes.
inline LinearSection elastic_section() {
  const Eigen::Matrix4d C = Eigen::Vector4d(5e7, 300, 2400, 2400).asDiagonal();
  return {.C = {C, C}};
}

/// The unknowns after the whole element has turned about its first node by `turn` and then shifted; rotations are
/// given by their shortest vectors.
inline beam::SpatialVector moved_rigidly(const beam::SpatialElement& element, const beam::SpatialVector& q,
                                         const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) {
  beam::SpatialVector out;
  out.segment<3>(0) = turn * q.segment<3>(0) + shift;
  out.segment<3>(6) = turn * (element.span + q.segment<3>(6)) - element.span + shift;
  for (int at : {3, 9}) out.segment<3>(at) = math::rotation_vector(turn * math::rotation(q.segment<3>(at)));
  return out;
}

/// Elements and states of order 1 in every unit.
class RandomSpatialBeam {
 public:
  explicit RandomSpatialBeam(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Eigen::Vector3d vector(double size) {
    return Eigen::Vector3d::NullaryExpr([&](Eigen::Index) { return between(-size, size); });
  }
  Eigen::Vector3d direction() { return vector(1).normalized(); }
  /// About 1.3 m long, in any direction, and unbent at another angle than its chord's.
  beam::SpatialElement element() {
    const Eigen::Matrix3d axes = math::rotation(3 * direction());
    return {.span = 1.3 * axes.col(0), .length = between(1.2, 1.3), .triad = axes * math::rotation(vector(0.1))};
  }
  /// Bent and twisted between its nodes by up to 1 rad, its nodes turned by up to 2.5 rad in total.
  beam::SpatialVector position(const beam::SpatialElement& element) {
    beam::SpatialVector q;
    for (int at : {0, 6}) q.segment<3>(at) = vector(0.1);
    for (int at : {3, 9}) q.segment<3>(at) = between(0, 0.6) * direction();
    return moved_rigidly(element, q, math::rotation(between(0, 1.9) * direction()), vector(1));
  }
  LinearSection section() {
    LinearSection s;
    for (std::size_t g = 0; g < beam::gauss_points; ++g) {
      s.C[g] = Eigen::Matrix4d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return between(-2, 2); });
      s.offset[g] = Eigen::Vector4d::NullaryExpr([&](Eigen::Index) { return between(-1, 1); });
    }
    return s;
  }

 private:
  std::mt19937 random_;
};

inline beam::SpatialVector force_at(const beam::SpatialElement& element, const beam::SpatialVector& q,
                                    const LinearSection& section) {
  const beam::SpatialKinematics k = kinematics(element, q);
  return internal_force(element, k, section(k));
}

inline beam::SpatialMatrix tangent_at(const beam::SpatialElement& element, const beam::SpatialVector& q,
                                      const LinearSection& section) {
  const beam::SpatialKinematics k = kinematics(element, q);
  return tangent(element, k, section(k), {.C = section.C});
}

}  // namespace strandyn::test
