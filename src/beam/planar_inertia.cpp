#include "strandyn/beam/planar_inertia.hpp"

#include <cmath>

namespace strandyn::beam {
namespace {

/// Where the nodal directions point, and their normals; index 0 is node 1.
struct Tangents {
  std::array<Eigen::Vector2d, 2> along, normal;
};

Tangents tangents(const PlanarElement& element, const PlanarVector& q) {
  Tangents t;
  for (std::size_t i = 0; i < 2; ++i) {
    const double angle = q(i == 0 ? 2 : 5) + element.rest_angle;
    t.along[i] = {std::cos(angle), std::sin(angle)};
    t.normal[i] = {-t.along[i].y(), t.along[i].x()};
  }
  return t;
}

/// [kg] Hermite mass table of X = (x_1, t_1, x_2, t_2), [kg m] and [kg m^2] where a tangent takes part.
Eigen::Matrix4d hermite_table(const PlanarElement& element, const Inertia& inertia) {
  const double l = element.length;
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l,              //
      22 * l, 4 * l * l, 13 * l, -3 * l * l,  //
      54, 13 * l, 156, -22 * l,               //
      -13 * l, -3 * l * l, -22 * l, 4 * l * l;
  return inertia.mass * l / 420 * m;
}

/// d(X_1..X_4)/d(unknowns), each X a vector of the plane: two rows per entry.
Eigen::Matrix<double, 8, 6> directions(const Tangents& t) {
  Eigen::Matrix<double, 8, 6> J = Eigen::Matrix<double, 8, 6>::Zero();
  for (int i = 0; i < 2; ++i) {
    J.block<2, 2>(4 * i, 3 * i).setIdentity();
    J.block<2, 1>(4 * i + 2, 3 * i + 2) = t.normal[i];
  }
  return J;
}

/// The table acting on plane vectors.
Eigen::Matrix<double, 8, 8> on_vectors(const Eigen::Matrix4d& table) {
  Eigen::Matrix<double, 8, 8> m = Eigen::Matrix<double, 8, 8>::Zero();
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) m.block<2, 2>(2 * a, 2 * b) = table(a, b) * Eigen::Matrix2d::Identity();
  }
  return m;
}

/// Rotary inertia of the section, shared as the rotations are: linearly.
PlanarMatrix rotary_mass(const PlanarElement& element, const Inertia& inertia) {
  PlanarMatrix m = PlanarMatrix::Zero();
  const double J = inertia.rotary * element.length / 6;
  m(2, 2) = m(5, 5) = 2 * J;
  m(2, 5) = m(5, 2) = J;
  return m;
}

/// Second time derivative of (x_1, t_1, x_2, t_2).
Eigen::Matrix<double, 8, 1> second_derivative(const Tangents& t, const PlanarMotion& m) {
  Eigen::Matrix<double, 8, 1> X = directions(t) * m.a;
  for (int i = 0; i < 2; ++i) {
    const double rate = m.v(3 * i + 2);
    X.segment<2>(4 * i + 2) -= rate * rate * t.along[i];
  }
  return X;
}

}  // namespace

PlanarVector lumped_mass(const PlanarElement& element, const Inertia& inertia) {
  const double m = inertia.mass * element.length / 2;
  const double J = inertia.rotary * element.length / 2;
  PlanarVector diagonal;
  diagonal << m, m, J, m, m, J;
  return diagonal;
}

PlanarMatrix consistent_mass(const PlanarElement& element, const Inertia& inertia, const PlanarVector& q) {
  const auto J = directions(tangents(element, q));
  return J.transpose() * on_vectors(hermite_table(element, inertia)) * J + rotary_mass(element, inertia);
}

PlanarVector consistent_inertia_force(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m) {
  const Tangents t = tangents(element, m.q);
  const Eigen::Matrix<double, 8, 1> P = on_vectors(hermite_table(element, inertia)) * second_derivative(t, m);
  return directions(t).transpose() * P + rotary_mass(element, inertia) * m.a;
}

InertiaTangent consistent_inertia_tangent(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m) {
  const Tangents t = tangents(element, m.q);
  const auto J = directions(t);
  const Eigen::Matrix<double, 8, 8> table = on_vectors(hermite_table(element, inertia));
  const Eigen::Matrix<double, 8, 1> P = table * second_derivative(t, m);

  // The second derivatives of the tangents: t'' = theta'' n - theta'^2 t, dn/dtheta = -t, dt/dtheta = n.
  Eigen::Matrix<double, 8, 6> by_velocity = Eigen::Matrix<double, 8, 6>::Zero();
  Eigen::Matrix<double, 8, 6> by_position = Eigen::Matrix<double, 8, 6>::Zero();
  PlanarMatrix turning = PlanarMatrix::Zero();
  for (int i = 0; i < 2; ++i) {
    const double rate = m.v(3 * i + 2);
    by_velocity.block<2, 1>(4 * i + 2, 3 * i + 2) = -2 * rate * t.along[i];
    by_position.block<2, 1>(4 * i + 2, 3 * i + 2) = -m.a(3 * i + 2) * t.along[i] - rate * rate * t.normal[i];
    turning(3 * i + 2, 3 * i + 2) = -t.along[i].dot(P.segment<2>(4 * i + 2));
  }
  return {.mass = J.transpose() * table * J + rotary_mass(element, inertia),
          .velocity = J.transpose() * table * by_velocity,
          .position = J.transpose() * table * by_position + turning};
}

}  // namespace strandyn::beam
