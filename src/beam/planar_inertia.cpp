#include "strandyn/beam/planar_inertia.hpp"

#include <cmath>

#include "hermite_table.hpp"

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

/// Entries of a 6 x 6 matrix in which the table couples directions: translations e_x, e_y of node i and, for its
/// rotation, `row[i]`, with the same of node j, times `factor`, and `column[j]`.
PlanarMatrix couple(const Eigen::Matrix4d& table, const std::array<Eigen::Vector2d, 2>& row, double factor,
                    const std::array<Eigen::Vector2d, 2>& column) {
  PlanarMatrix m;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const auto ri = static_cast<std::size_t>(i);
      const auto cj = static_cast<std::size_t>(j);
      m.block<2, 2>(3 * i, 3 * j) = factor * table(2 * i, 2 * j) * Eigen::Matrix2d::Identity();
      m.block<2, 1>(3 * i, 3 * j + 2) = table(2 * i, 2 * j + 1) * column[cj];
      m.block<1, 2>(3 * i + 2, 3 * j) = factor * table(2 * i + 1, 2 * j) * row[ri].transpose();
      m(3 * i + 2, 3 * j + 2) = table(2 * i + 1, 2 * j + 1) * row[ri].dot(column[cj]);
    }
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

using FourVectors = Eigen::Matrix<double, 4, 2>;  // one row for each of x_1, t_1, x_2, t_2

/// The table times the second time derivative of (x_1, t_1, x_2, t_2): t'' = theta'' n - theta'^2 t.
FourVectors momentum_rate(const Eigen::Matrix4d& table, const Tangents& t, const PlanarMotion& m) {
  FourVectors X;
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double rate = m.v(3 * i + 2);
    X.row(2 * i) = m.a.segment<2>(3 * i).transpose();
    X.row(2 * i + 1) = (m.a(3 * i + 2) * t.normal[at] - rate * rate * t.along[at]).transpose();
  }
  return table * X;
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
  const Tangents t = tangents(element, q);
  return couple(hermite_table(inertia.mass, element.length), t.normal, 1, t.normal) + rotary_mass(element, inertia);
}

PlanarVector consistent_inertia_force(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m) {
  const Tangents t = tangents(element, m.q);
  const FourVectors P = momentum_rate(hermite_table(inertia.mass, element.length), t, m);
  PlanarVector force;
  for (int i = 0; i < 2; ++i) {
    force.segment<2>(3 * i) = P.row(2 * i).transpose();
    force(3 * i + 2) = P.row(2 * i + 1).dot(t.normal[static_cast<std::size_t>(i)]);
  }
  if (inertia.rotary > 0) force += rotary_mass(element, inertia) * m.a;
  return force;
}

PlanarMatrix consistent_inertia_tangent(const PlanarElement& element, const Inertia& inertia, const PlanarMotion& m,
                                        InertiaFactors factors) {
  const Tangents t = tangents(element, m.q);
  const Eigen::Matrix4d table = hermite_table(inertia.mass, element.length);
  const FourVectors P = momentum_rate(table, t, m);

  // Derivatives of the tangents' second derivatives, dn/dtheta = -t, dt/dtheta = n: of theta'' n - theta'^2 t by all
  // three. Translations have only the first.
  std::array<Eigen::Vector2d, 2> by_rotation;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto rotation = static_cast<Eigen::Index>(3 * i + 2);
    const double rate = m.v(rotation);
    by_rotation[i] = (factors.acceleration - factors.position * rate * rate) * t.normal[i] -
                     (2 * factors.velocity * rate + factors.position * m.a(rotation)) * t.along[i];
  }
  PlanarMatrix tangent = couple(table, t.normal, factors.acceleration, by_rotation);
  if (inertia.rotary > 0) tangent += factors.acceleration * rotary_mass(element, inertia);
  // The normal that the force is taken along turns as well.
  for (int i = 0; i < 2; ++i) {
    tangent(3 * i + 2, 3 * i + 2) -=
        factors.position * t.along[static_cast<std::size_t>(i)].dot(P.row(2 * i + 1).transpose());
  }
  return tangent;
}

double kinetic_energy(const PlanarElement& element, const Inertia& inertia, const PlanarVector& q,
                      const PlanarVector& v) {
  const Tangents t = tangents(element, q);
  FourVectors X;
  for (int i = 0; i < 2; ++i) {
    X.row(2 * i) = v.segment<2>(3 * i).transpose();
    X.row(2 * i + 1) = v(3 * i + 2) * t.normal[static_cast<std::size_t>(i)].transpose();
  }
  const FourVectors momentum = hermite_table(inertia.mass, element.length) * X;
  const double rotary = inertia.rotary * element.length / 3 * (v(2) * v(2) + v(2) * v(5) + v(5) * v(5));
  return (X.cwiseProduct(momentum).sum() + rotary) / 2;
}

}  // namespace strandyn::beam
