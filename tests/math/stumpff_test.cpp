#include "strandyn/math/stumpff.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/check_close.hpp"
#include "support/derivative.hpp"

using namespace strandyn::math;
using strandyn::test::check_close;
using strandyn::test::derivative;

namespace {

double factorial(std::size_t k) {
  return std::tgamma(static_cast<double>(k) + 1);
}

/// The series as it is written, in long double.
double plain_series(double s, std::size_t k) {
  long double term = 1.0L;
  for (std::size_t j = 2; j <= k; ++j) term /= static_cast<long double>(j);
  long double sum = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    sum += term;
    term *= -static_cast<long double>(s) / static_cast<long double>((2 * i + k + 1) * (2 * i + k + 2));
  }
  return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("stumpff: the functions are their series up to a full turn and beyond") {
  for (const double angle : {0.0, 1e-9, 1e-4, 0.01, 0.3, 1.0, 1.5, 2.0, 2.5, 2.9999, 3.0001, 3.2, 4.5, 6.2, 7.0}) {
    const double s = angle * angle;
    const Stumpff c = stumpff(s);
    // Measured: 1.7e-15 at the worst, by the highest just above the limit of the series.
    for (std::size_t k = 0; k < c.size(); ++k) {
      check_close(c[k], plain_series(s, k), {.relative = 0, .absolute = 2e-15 / factorial(k)});
    }
  }
}

TEST_CASE("stumpff: at a tiny argument the functions are the reciprocal factorials to the last digit") {
  const Stumpff c = stumpff(1e-18);
  for (std::size_t k = 0; k < c.size(); ++k) {
    check_close(c[k], 1 / factorial(k), {.relative = std::numeric_limits<double>::epsilon()});
  }
}

TEST_CASE("stumpff: near a whole turn the spin map keeps the digits of what is left of it") {
  const double left = 1e-6;
  const double angle = 2 * std::numbers::pi - left;
  const Stumpff c = stumpff(angle * angle);
  // 1 - cos = left^2/2 (1 - left^2/12); the angle itself is known to 9e-16, 1e-9 of what is left.
  check_close(c[2], left * left / 2 / (angle * angle), {.relative = 4e-9});
}

TEST_CASE("stumpff: the derivatives are those of the functions") {
  for (const double s : {0.01, 0.7, 3.0, 6.25, 8.0, 12.0, 30.0}) {
    const Stumpff c = stumpff(s);
    // The differences carry rounding of 1e-16/1e-3 and a truncation below it.
    for (std::size_t k = 0; k < 6; ++k) {
      check_close(stumpff_derivative(c, k), derivative([&](double d) { return stumpff(s + d)[k]; }),
                  {.relative = 0, .absolute = 1e-12 / factorial(k)});
    }
    for (std::size_t k = 0; k < 4; ++k) {
      check_close(stumpff_second_derivative(c, k),
                  derivative([&](double d) { return stumpff_derivative(stumpff(s + d), k); }),
                  {.relative = 0, .absolute = 1e-12 / factorial(k)});
    }
  }
}

TEST_CASE("stumpff: the first three rotate a vector about an axis") {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.6, -0.3, 0.7).normalized();
  const Eigen::Vector3d a(1, 2, -0.5);
  for (const double angle : {1e-9, 0.4, 1.7, 2.99, 3.01, 5.0, 9.0}) {
    const Eigen::Vector3d psi = angle * axis;
    const Stumpff c = stumpff(psi.squaredNorm());
    const Eigen::Vector3d rotated = c[0] * a + c[1] * psi.cross(a) + c[2] * psi.dot(a) * psi;
    CHECK((rotated - Eigen::AngleAxisd(angle, axis) * a).norm() <= 2e-15);
  }
}
