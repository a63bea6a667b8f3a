#pragma once
/// \file Elements and nodal states for tests of the beam, of order 1 in every unit.

#include <cmath>
#include <random>

#include "strandyn/beam/planar_element.hpp"

namespace strandyn::test {

class RandomBeam {
 public:
  explicit RandomBeam(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  beam::PlanarVector vector(double size) {
    return beam::PlanarVector::NullaryExpr([&](Eigen::Index) { return between(-size, size); });
  }
  /// About 1.3 m long, in any direction, somewhat stretched, and unbent at another angle than its chord's.
  beam::PlanarElement element() {
    const double angle = between(-3, 3);
    const Eigen::Vector2d span = 1.3 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return {.span = span, .length = between(1.2, 1.3), .rest_angle = angle + between(-0.1, 0.1)};
  }
  /// Displaced, turned by any angle up to two turns, and bent by a fraction of a radian.
  beam::PlanarVector position(const beam::PlanarElement& element);

 private:
  std::mt19937 random_;
};

inline Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle) {
  return Eigen::Rotation2Dd(angle) * v;
}

/// The unknowns after the whole element has turned about its first node and then shifted. A turn counts as such.
inline beam::PlanarVector moved_rigidly(const beam::PlanarElement& element, const beam::PlanarVector& q, double angle,
                                        const Eigen::Vector2d& shift) {
  beam::PlanarVector out;
  out.segment<2>(0) = turned(q.segment<2>(0), angle) + shift;
  out.segment<2>(3) = turned(element.span + q.segment<2>(3), angle) - element.span + shift;
  out(2) = q(2) + angle;
  out(5) = q(5) + angle;
  return out;
}

inline beam::PlanarVector RandomBeam::position(const beam::PlanarElement& element) {
  const Eigen::Vector2d shift(between(-1, 1), between(-1, 1));
  return moved_rigidly(element, vector(0.2), between(-12, 12), shift);
}

}  // namespace strandyn::test
