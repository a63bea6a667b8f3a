#include "strandyn/math/block_tridiagonal.hpp"

#include <doctest/doctest.h>

#include <random>

#include "math/dense.hpp"
#include "support/check_close.hpp"

using namespace strandyn::math;
using strandyn::test::dense;

namespace {

using Numbers = std::mt19937;

template <class Matrix>
void fill(Matrix& block, Numbers& random) {
  std::uniform_real_distribution<double> between(-1, 1);
  for (double& entry : block.reshaped()) entry = between(random);
}

/// Unsymmetric, with blocks on the diagonal that outweigh those beside it.
template <int B>
BlockTridiagonal<B> random_matrix(std::size_t nodes, Numbers& random) {
  BlockTridiagonal<B> a(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    fill(a.diagonal(i), random);
    a.diagonal(i).diagonal().array() += 4 * B;
    if (i + 1 == nodes) break;
    fill(a.upper(i), random);
    fill(a.lower(i), random);
  }
  return a;
}

Eigen::VectorXd random_vector(Eigen::Index size, Numbers& random) {
  Eigen::VectorXd x(size);
  fill(x, random);
  return x;
}

/// |A x - b| over |A| |x|: what backward stable solutions keep near rounding.
template <int B>
double relative_residual(const BlockTridiagonal<B>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const Eigen::MatrixXd full = dense(a);
  return (full * x - b).lpNorm<Eigen::Infinity>() /
         (full.cwiseAbs().rowwise().sum().maxCoeff() * x.lpNorm<Eigen::Infinity>());
}

template <int B>
double residual_of_solution(const BlockTridiagonal<B>& a, Numbers& random) {
  const Eigen::VectorXd b = random_vector(static_cast<Eigen::Index>(a.nodes()) * B, random);
  BlockTridiagonalLU<B> factors;
  REQUIRE(factors.factorize(a));
  Eigen::VectorXd x = b;
  factors.solve(x.data());
  return relative_residual(a, x, b);
}

}  // namespace

TEST_CASE("block tridiagonal: the product is that of the full matrix") {
  Numbers random(1);
  const auto a = random_matrix<3>(7, random);
  const Eigen::VectorXd x = random_vector(21, random);
  Eigen::VectorXd y(21);
  a.multiply(x.data(), y.data());
  CHECK((y - dense(a) * x).lpNorm<Eigen::Infinity>() <= 1e-14);
}

TEST_CASE("block tridiagonal: the solution satisfies an unsymmetric system for blocks of 1 to 7") {
  Numbers random(2);
  for (const std::size_t nodes : {1, 2, 3, 50}) {
    CHECK(residual_of_solution(random_matrix<1>(nodes, random), random) <= 1e-15);
    CHECK(residual_of_solution(random_matrix<3>(nodes, random), random) <= 1e-15);
    CHECK(residual_of_solution(random_matrix<7>(nodes, random), random) <= 1e-15);  // by pivoted LU
  }
}

TEST_CASE("block tridiagonal: forces and moments of very different size are solved alike") {
  // Rows and columns scaled as newtons per metre and newton metres per radian of a fine mesh are: the solution is the
  // scaled one of the unscaled system, digit by digit.
  Numbers random(3);
  const auto a = random_matrix<3>(20, random);
  const Eigen::Vector3d scale(1e5, 1e2, 1e-3);
  auto scaled = a;
  for (std::size_t i = 0; i < a.nodes(); ++i) {
    scaled.diagonal(i) = scale.asDiagonal() * a.diagonal(i) * scale.asDiagonal();
    if (i + 1 == a.nodes()) break;
    scaled.upper(i) = scale.asDiagonal() * a.upper(i) * scale.asDiagonal();
    scaled.lower(i) = scale.asDiagonal() * a.lower(i) * scale.asDiagonal();
  }
  const Eigen::VectorXd scales = scale.replicate(20, 1);
  Eigen::VectorXd x = random_vector(60, random);
  Eigen::VectorXd y = scales.cwiseProduct(x);
  BlockTridiagonalLU<3> factors;
  REQUIRE(factors.factorize(a));
  factors.solve(x.data());
  REQUIRE(factors.factorize(scaled));
  factors.solve(y.data());
  CHECK((scales.cwiseProduct(y) - x).lpNorm<Eigen::Infinity>() <= 1e-14);
}

TEST_CASE("block tridiagonal: a singular block is refused and new factors can follow") {
  Numbers random(4);
  auto a = random_matrix<3>(5, random);
  const auto sound = a;
  a.diagonal(0).setZero();
  BlockTridiagonalLU<3> factors;
  CHECK_FALSE(factors.factorize(a));
  CHECK(factors.factorize(sound));
}

TEST_CASE("block tridiagonal: elements add up where they share a node") {
  Numbers random(5);
  BlockTridiagonal<3> a(4);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(12, 12);
  for (Eigen::Index i = 0; i < 3; ++i) {
    Eigen::Matrix<double, 6, 6> k;
    fill(k, random);
    a.add_element(static_cast<std::size_t>(i), k);
    expected.block<6, 6>(3 * i, 3 * i) += k;
  }
  CHECK(dense(a) == expected);
  a.set_zero();
  CHECK(dense(a).isZero(0));
}

TEST_CASE("block tridiagonal: a pinned unknown takes its right side and leaves the other equations alone") {
  Numbers random(6);
  for (const std::size_t node : {0, 2, 4}) {
    auto a = random_matrix<3>(5, random);
    const auto pinned = static_cast<Eigen::Index>(3 * node + 1);
    Eigen::MatrixXd expected = dense(a);
    expected.row(pinned).setZero();
    expected.col(pinned).setZero();
    expected(pinned, pinned) = 1;
    a.pin(node, 1);
    CHECK(dense(a) == expected);
    Eigen::VectorXd x = random_vector(15, random);
    const double wanted = x(pinned);
    BlockTridiagonalLU<3> factors;
    REQUIRE(factors.factorize(a));
    factors.solve(x.data());
    CHECK(std::abs(x(pinned) - wanted) <= 1e-16);
  }
}
