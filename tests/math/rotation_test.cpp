#include "strandyn/math/rotation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "strandyn/math/stumpff.hpp"
#include "support/derivative.hpp"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace strandyn::math;
using strandyn::test::derivative;

namespace {

constexpr double pi = std::numbers::pi;

class RandomVectors {
 public:
  explicit RandomVectors(unsigned seed) : random_(seed) {}
  Vector3d direction() { return vector().normalized(); }
  Vector3d vector() {
    return Vector3d::NullaryExpr([&](Eigen::Index) { return std::normal_distribution<double>()(random_); });
  }

 private:
  std::mt19937 random_;
};

/// The vector of a skew matrix.
Vector3d axial(const Matrix3d& S) {
  return Vector3d(S(2, 1) - S(1, 2), S(0, 2) - S(2, 0), S(1, 0) - S(0, 1)) / 2;
}

/// Columns: derivative of a vector by the three components of psi.
template <class F>
Matrix3d slope_of(F&& f, const Vector3d& psi) {
  Matrix3d out;
  for (int j = 0; j < 3; ++j) out.col(j) = derivative([&](double s) { return f(psi + s * Vector3d::Unit(j)); });
  return out;
}

}  // namespace

TEST_CASE("rotation: it is the rotation about its vector by its length, for any number of turns") {
  RandomVectors random(1);
  for (const double angle : {0.0, 1e-12, 1e-6, 0.3, 1.0, 2.999, 3.001, pi, 5.0, 2 * pi, 6.3, 40 * pi, 127.0}) {
    const Vector3d axis = random.direction();
    const Matrix3d R = rotation(angle * axis);
    const Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    // Rounding of the angle itself, 1e-16 of 127 rad, and of some products.
    const double allowed = 1e-15 + 3e-16 * angle;
    CHECK((R - expected).cwiseAbs().maxCoeff() <= allowed);
    CHECK((R * R.transpose() - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 2e-15);
    CHECK((R * axis - axis).norm() <= 2e-15);
  }
}

TEST_CASE("rotation: the shortest vector comes back from the matrix, relative to its size when it is tiny") {
  RandomVectors random(2);
  for (const double angle : {1e-300, 1e-100, 1e-20, 1e-12, 1e-9, 1e-8, 3e-8, 1e-4, 0.1, 1.0, 2.0, 2.2, 3.0, pi - 1e-4,
                             pi - 1e-9, pi - 1e-13}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3d psi = angle * random.direction();
      // Ten units of rounding: the matrix holds one in each of its entries.
      CHECK((rotation_vector(rotation(psi)) - psi).norm() <= 2e-15 * angle);
    }
  }
  CHECK(rotation_vector(Matrix3d::Identity()) == Vector3d::Zero());
}

TEST_CASE("rotation: at half a turn either sense is right, and the vector is half a turn long") {
  RandomVectors random(3);
  for (int i = 0; i < 50; ++i) {
    const Vector3d axis = i < 3 ? Vector3d(Vector3d::Unit(i)) : random.direction();
    const Vector3d psi = rotation_vector(rotation(pi * axis));
    CHECK(psi.norm() <= pi * (1 + 1e-15));
    CHECK(std::min((psi - pi * axis).norm(), (psi + pi * axis).norm()) <= 5e-15);
  }
}

TEST_CASE("rotation: the spin map is the derivative of the rotation") {
  RandomVectors random(4);
  for (const double angle : {0.0, 1e-9, 1e-3, 0.5, 1.9, 2.9, 3.1, 6.0, 2 * pi, 7.0, 30.0}) {
    const Vector3d psi = angle * random.direction();
    const Matrix3d R = rotation(psi);
    const Matrix3d expected = slope_of([&](const Vector3d& at) { return axial(rotation(at) * R.transpose()); }, psi);
    // Measured 3e-12 at most: the error of the differences.
    CHECK((spin_map(psi) - expected).cwiseAbs().maxCoeff() <= 1e-11);
  }
}

TEST_CASE("rotation: the inverse spin map undoes the spin map up to near a full turn") {
  RandomVectors random(5);
  for (const double angle : {0.0, 1e-12, 1e-3, 0.5, 2.999, 3.001, pi, 5.0, 6.2}) {
    const Vector3d psi = angle * random.direction();
    const Matrix3d T = spin_map(psi);
    const Matrix3d inverse = inverse_spin_map(psi);
    CHECK((inverse * T - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 2e-15 * inverse.norm());
    CHECK((T * psi - psi).norm() <= 1e-15 * (1 + angle));
  }
}

TEST_CASE("rotation: the slopes of transposed spin maps are those of differences") {
  RandomVectors random(6);
  for (const double angle : {0.0, 1e-9, 1e-3, 0.5, 1.9, 2.9, 3.1, 4.5, 2 * pi, 25.0}) {
    const Vector3d psi = angle * random.direction();
    const Vector3d m = random.vector();
    const Matrix3d slope = spin_map_transposed_slope(psi, m);
    const auto moment = [&](const Vector3d& at) -> Vector3d { return spin_map(at).transpose() * m; };
    CHECK((slope - slope_of(moment, psi)).cwiseAbs().maxCoeff() <= 2e-12 * m.norm());
    if (angle > 5) continue;
    const Matrix3d inverse_slope = inverse_spin_map_transposed_slope(psi, m);
    const auto inverse = [&](const Vector3d& at) -> Vector3d { return inverse_spin_map(at).transpose() * m; };
    CHECK((inverse_slope - slope_of(inverse, psi)).cwiseAbs().maxCoeff() <= 1e-11 * m.norm());
  }
}

TEST_CASE("rotation: slopes lose no digits near zero") {
  // T = 1 + S/2 + S S/6 - (angle^2/24) S, inverse 1 - S/2 + S S/12; what follows is of third order in the slopes.
  const Vector3d m(0.3, -1.2, 0.8);
  const Vector3d direction = Vector3d(1, 2, -2) / 3;
  for (const double angle : {1e-12, 1e-9, 1e-6, 1e-4}) {
    const Vector3d psi = angle * direction;
    Matrix3d bilinear = psi * m.transpose() - 2 * m * psi.transpose();
    bilinear.diagonal().array() += psi.dot(m);
    const double allowed = angle * angle * angle;
    const Matrix3d second = psi.cross(m) * psi.transpose() / 12 - angle * angle / 24 * skew(m);
    const Matrix3d forward = spin_map_transposed_slope(psi, m) - skew(m) / 2 - second;
    const Matrix3d backward = inverse_spin_map_transposed_slope(psi, m) + skew(m) / 2;
    // Half of a skew matrix was taken off: its rounding is 1e-16.
    CHECK((forward - bilinear / 6).cwiseAbs().maxCoeff() <= allowed + 5e-16);
    CHECK((backward - bilinear / 12).cwiseAbs().maxCoeff() <= allowed + 5e-16);
    CHECK((spin_map(psi) - Matrix3d::Identity() - skew(psi) / 2).cwiseAbs().maxCoeff() <= angle * angle + 5e-16);
  }
}

TEST_CASE("rotation: series and closed forms meet where one hands over to the other") {
  // At an angle of 3 the coefficients are found another way; all together make these matrices.
  const Vector3d axis = Vector3d(2, -1, 2) / 3;
  const Vector3d m(1, 0.5, -2);
  const Vector3d below = 2.999999999999999 * axis;
  const Vector3d above = 3.000000000000001 * axis;
  CHECK(below.squaredNorm() < detail::stumpff_series_limit);
  CHECK(above.squaredNorm() > detail::stumpff_series_limit);
  // The two angles differ by 2e-15; rounding is as much.
  const auto distance = [](const Matrix3d& a, const Matrix3d& b) { return (a - b).cwiseAbs().maxCoeff(); };
  CHECK(distance(rotation(below), rotation(above)) <= 3e-15);
  CHECK(distance(spin_map_transposed_slope(below, m), spin_map_transposed_slope(above, m)) <= 5e-15);
  CHECK(distance(inverse_spin_map_transposed_slope(below, m), inverse_spin_map_transposed_slope(above, m)) <= 5e-15);
}

TEST_CASE("rotation: a shortened vector is the same rotation with the same angular velocity") {
  RandomVectors random(7);
  for (const double angle : {0.0, 1.0, 3.1, 3.2, 5.0, 2 * pi, 6.4, 9.0, 10.0, 126.0}) {
    const RotationState before = {.psi = angle * random.direction(), .rate = random.vector()};
    const RotationState after = shortened(before);
    CHECK(after.psi.norm() <= pi * (1 + 1e-15));
    if (angle < pi) CHECK(after.psi == before.psi);
    // Rounding of the long vector: 1e-16 of its angle.
    const double allowed = 2e-15 + 5e-16 * angle;
    CHECK((rotation(after.psi) - rotation(before.psi)).cwiseAbs().maxCoeff() <= allowed);
    CHECK((spin_map(after.psi) * after.rate - spin_map(before.psi) * before.rate).norm() <= 4 * allowed);
  }
}
