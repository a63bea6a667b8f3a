#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "beam/spatial_states.hpp"
#include "strandyn/beam/spatial_element.hpp"
#include "strandyn/math/rotation.hpp"
#include "support/check_close.hpp"

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using namespace strandyn::beam;
using strandyn::math::rotation;
using strandyn::test::check_close;
using strandyn::test::elastic_section;
using strandyn::test::force_at;
using strandyn::test::LinearSection;
using strandyn::test::RandomSpatialBeam;
using strandyn::test::strain;
using strandyn::test::tangent_at;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("spatial element: on a helix it has the curvature and twist of the helix up to second order") {
  // A rod of constant curvature kappa in its own axes: R(s) = exp(s kappa), x(s) = s T(s kappa) e1.
  RandomSpatialBeam random(9);
  for (int i = 0; i < 20; ++i) {
    const Vector3d kappa = random.direction();
    const auto error = [&](double h) -> Vector4d {
      const SpatialElement element = {.span = {h, 0, 0}, .length = h};
      SpatialVector q = SpatialVector::Zero();
      q.segment<3>(6) = h * (strandyn::math::spin_map(h * kappa).col(0) - Vector3d::UnitX());
      q.segment<3>(9) = h * kappa;
      const SpatialKinematics k = kinematics(element, q);
      // One strain, the same all along: both Gauss points see their mean up to third order of h.
      return (strain(k, 0) + strain(k, 1)) / 2 - Vector4d(0, kappa.x(), kappa.y(), kappa.z());
    };
    const Vector4d coarse = error(0.2);
    const Vector4d fine = error(0.1);
    // A plane arc of angle h has a strain of h^4/1920; with twist, less.
    CHECK(std::abs(coarse(0)) <= std::pow(0.2, 4) / 1900);
    CHECK(std::abs(fine(0)) <= std::pow(0.1, 4) / 1900);
    check_close(coarse.tail<3>().norm() / fine.tail<3>().norm(), 4, {.relative = 0.2 * 0.2 / 4});
    CHECK(fine.tail<3>().norm() <= 0.1 * 0.1 / 24);
  }
}

TEST_CASE("spatial element: at rest its stiffness is the textbook's with its tension") {
  const double l = 0.7;
  const double EA = 3, GJ = 0.4, EI2 = 1.3, EI3 = 2.1, N = 0.9;
  const SpatialElement element = {.span = {l, 0, 0}, .length = l};
  const SpatialKinematics k = kinematics(element, SpatialVector::Zero());
  const Matrix4d C = Vector4d(EA, GJ, EI2, EI3).asDiagonal();
  const SpatialMatrix K = tangent(element, k, {.N = {N, N}}, {.C = {C, C}});
  SpatialMatrix expected = SpatialMatrix::Zero();
  const auto bar = [&](int i, int j, double stiffness) {
    expected(i, i) = expected(j, j) = stiffness / l;
    expected(i, j) = expected(j, i) = -stiffness / l;
  };
  bar(0, 6, EA);
  bar(3, 9, GJ);
  // Deflection w and slope of both nodes; about axis 2 the rotation is minus the slope.
  const auto beam = [&](std::array<int, 4> at, double sign, double EI) {
    Matrix4d bending;
    bending << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l,  //
        -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l, 4 * l * l;
    Matrix4d string;
    string << 36, 3 * l, -36, 3 * l, 3 * l, 4 * l * l, -3 * l, -l * l,  //
        -36, -3 * l, 36, -3 * l, 3 * l, -l * l, -3 * l, 4 * l * l;
    const Matrix4d sum = EI / (l * l * l) * bending + N / (30 * l) * string;
    const Vector4d flip(1, sign, 1, sign);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) expected(at[i], at[j]) = flip(i) * flip(j) * sum(i, j);
    }
  };
  beam({1, 5, 7, 11}, 1, EI3);
  beam({2, 4, 8, 10}, -1, EI2);
  CHECK((K - expected).cwiseAbs().maxCoeff() <= 1e-15 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE("spatial element: the 45 degree bend of Bathe and Bolourchi comes to its place in space") {
  // An eighth of a circle of radius 100, clamped, loaded out of its plane at its tip; a unit square with nu = 0.
  constexpr int elements = 8;
  constexpr int unknowns = 6 * elements;
  const auto point = [](int node) -> Vector3d {
    const double angle = pi / 4 * node / elements;
    return {100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0};
  };
  const Matrix4d C = Vector4d(1e7, 1e7 / 12, 1e7 / 12, 1e7 / 12).asDiagonal();
  const LinearSection section = {.C = {C, C}};
  struct Published {
    double load;
    Vector3d tip;
  };
  // J. C. Simo, L. Vu-Quoc, Comput. Methods Appl. Mech. Eng. 58, 1986: eight straight elements.
  const std::array<Published, 3> published = {
      {{300, {58.84, 22.33, 40.08}}, {450, {52.32, 18.62, 48.39}}, {600, {47.23, 15.79, 53.37}}}};
  Eigen::VectorXd q = Eigen::VectorXd::Zero(unknowns + 6);  // of all nodes, the clamped one first
  for (const auto& [load, tip] : published) {
    int iterations = 0;
    for (double change = 1; change > 1e-9 && iterations < 20; ++iterations) {
      Eigen::VectorXd out = Eigen::VectorXd::Zero(unknowns + 6);
      Eigen::MatrixXd K = Eigen::MatrixXd::Zero(unknowns + 6, unknowns + 6);
      out(unknowns + 2) = load;
      for (int e = 0; e < elements; ++e) {
        const Vector3d span = point(e + 1) - point(e);
        const SpatialElement element = {
            .span = span, .length = span.norm(), .triad = rotation({0, 0, std::atan2(span.y(), span.x())})};
        out.segment<12>(6 * e) -= force_at(element, q.segment<12>(6 * e), section);
        K.block<12, 12>(6 * e, 6 * e) += tangent_at(element, q.segment<12>(6 * e), section);
      }
      const Eigen::VectorXd step = K.bottomRightCorner<unknowns, unknowns>().lu().solve(out.tail<unknowns>());
      q.tail<unknowns>() += step;
      change = step.lpNorm<Eigen::Infinity>();
    }
    CHECK(iterations < 15);  // Newton's: few
    // Eight elements are 0.04 from sixteen here; the published ones have their own error of that size.
    CHECK((point(elements) + q.segment<3>(unknowns) - tip).lpNorm<Eigen::Infinity>() <= 0.1);
  }
}

TEST_CASE("spatial element: twist alone is twist alone") {
  RandomSpatialBeam random(8);
  for (const double angle : {1e-9, 1e-3, 0.5, 3.0}) {
    const Matrix3d axes = rotation(3 * random.direction());
    const SpatialElement element = {.span = 2 * axes.col(0), .length = 2, .triad = axes};
    SpatialVector q = SpatialVector::Zero();
    q.segment<3>(3) = 0.4 * axes.col(0);
    q.segment<3>(9) = (0.4 + angle) * axes.col(0);
    const SpatialKinematics k = kinematics(element, q);
    check_close(k.chi1, angle / 2, {.relative = 1e-15, .absolute = 2e-16});
    for (std::size_t g = 0; g < gauss_points; ++g) {
      CHECK(std::abs(k.eps) + std::abs(k.chi2[g]) + std::abs(k.chi3[g]) <= 2e-15);
    }
    const SpatialVector force = force_at(element, q, elastic_section());
    const Vector3d torque = 300 * angle / 2 * axes.col(0);
    CHECK((force.segment<3>(9) - torque).norm() <= 1e-11);  // rounding of curvature, 1e-15, times EI
    CHECK((force.segment<3>(3) + torque).norm() <= 1e-11);
  }
}
