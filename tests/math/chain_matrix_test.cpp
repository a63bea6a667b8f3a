#include "strandyn/math/chain_matrix.hpp"

#include <doctest/doctest.h>

#include <random>

#include "math/dense.hpp"

using namespace strandyn::math;
using strandyn::test::dense;

namespace {

constexpr std::size_t nodes = 6;

class RandomChain {
 public:
  explicit RandomChain(unsigned seed) : random_(seed) {}

  Eigen::MatrixXd numbers(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd x(rows, columns);
    for (double& entry : x.reshaped()) entry = between_(random_);
    return x;
  }
  /// Unsymmetric; blocks on the diagonal outweigh those beside it and the update.
  ChainMatrix matrix(int block, bool with_update) {
    ChainMatrix a(block, nodes);
    with_block_size(block, [&](auto B) {
      auto& t = a.as<B()>();
      for (std::size_t i = 0; i < nodes; ++i) {
        t.diagonal(i) = numbers(B(), B());
        t.diagonal(i).diagonal().array() += 5 * B();
        if (i + 1 == nodes) break;
        t.upper(i) = numbers(B(), B());
        t.lower(i) = numbers(B(), B());
      }
    });
    if (with_update) a.update() = {.column = vector(a), .row = vector(a)};
    return a;
  }
  Eigen::VectorXd vector(const ChainMatrix& a) { return numbers(static_cast<Eigen::Index>(a.size()), 1); }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> between_{-1, 1};
};

/// Calls `check(random, block, with_update)` for every kind of matrix.
template <class F>
void for_every_kind(F&& check) {
  for (int block = 2; block <= 6; ++block) {
    for (const bool with_update : {false, true}) {
      CAPTURE(block);
      CAPTURE(with_update);
      RandomChain random(static_cast<unsigned>(block));
      check(random, block, with_update);
    }
  }
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

Eigen::VectorXd solved(const ChainMatrix& a, Eigen::VectorXd x) {
  ChainFactors factors;
  REQUIRE(factors.factorize(a));
  factors.solve(x.data());
  return x;
}

}  // namespace

TEST_CASE("chain matrix: it is made of zeros and becomes so again") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    CHECK(dense(ChainMatrix(block, nodes)).isZero(0));
    ChainMatrix a = random.matrix(block, with_update);
    CHECK(a.block() == block);
    CHECK(a.nodes() == nodes);
    CHECK(a.size() == nodes * static_cast<std::size_t>(block));
    a.set_zero();
    CHECK(dense(a).isZero(0));
    CHECK_FALSE(a.update().has_value());
  });
}

TEST_CASE("chain matrix: products and solutions are those of the full matrix") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    const ChainMatrix a = random.matrix(block, with_update);
    const Eigen::MatrixXd full = dense(a);
    const Eigen::VectorXd x = random.vector(a);
    Eigen::VectorXd y(x.size());
    a.multiply(x.data(), y.data());
    CHECK(difference(y, full * x) <= 1e-13);  // sums of some 40 numbers of order 10
    CHECK(difference(solved(a, x), full.partialPivLu().solve(x)) <= 1e-14);
  });
}

TEST_CASE("chain matrix: factors serve one matrix after another of any kind") {
  ChainFactors factors;
  for_every_kind([&](RandomChain& random, int block, bool with_update) {
    const ChainMatrix a = random.matrix(block, with_update);
    Eigen::VectorXd x = random.vector(a);
    const Eigen::VectorXd expected = dense(a).partialPivLu().solve(x);
    REQUIRE(factors.factorize(a));
    factors.solve(x.data());
    CHECK(difference(x, expected) <= 1e-14);
  });
}

TEST_CASE("chain matrix: factors fit matrices of their own blocks and nodes, and an update its own matrix") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    ChainMatrix a = random.matrix(block, with_update);
    ChainFactors factors;
    CHECK_FALSE(factors.fit(a));
    REQUIRE(factors.factorize(a));
    CHECK(factors.fit(a));
    CHECK_FALSE(factors.fit(ChainMatrix(block, nodes + 1)));
    CHECK_FALSE(factors.fit(ChainMatrix(block == 6 ? 2 : block + 1, nodes)));
    CHECK(a.fits_update());
    if (!with_update) return;
    a.update()->row.conservativeResize(4);
    CHECK_FALSE(a.fits_update());
  });
}

TEST_CASE("chain matrix: a multiple of another is added and scales its update") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    ChainMatrix a = random.matrix(block, false);
    ChainMatrix b = random.matrix(block, with_update);
    Eigen::MatrixXd expected = dense(a) - 0.3 * dense(b);
    ChainMatrix sum = a;
    sum.add(-0.3, b);
    CHECK(difference(dense(sum), expected) <= 1e-14);
    expected = dense(b) - 0.3 * dense(a);
    b.add(-0.3, a);
    CHECK(difference(dense(b), expected) <= 1e-14);
  });
}

TEST_CASE("chain matrix: a number is added where two unknowns of one node meet") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    ChainMatrix a = random.matrix(block, with_update);
    Eigen::MatrixXd expected = dense(a);
    const std::size_t first = 2 * static_cast<std::size_t>(block);
    a.add_at_node(first, first + 1, 7);
    expected(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(first) + 1) += 7;
    CHECK(difference(dense(a), expected) <= 1e-14);
  });
}

TEST_CASE("chain matrix: a pinned row reads its right side and leaves the other equations alone") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    for (const std::size_t i : {std::size_t{0}, 2 * static_cast<std::size_t>(block) + 1}) {
      ChainMatrix a = random.matrix(block, with_update);
      const auto at = static_cast<Eigen::Index>(i);
      Eigen::MatrixXd expected = dense(a);
      expected.row(at) = Eigen::VectorXd::Unit(expected.rows(), at).transpose();
      a.pin_row(i);
      CHECK(difference(dense(a), expected) <= 0);
      const Eigen::VectorXd b = random.vector(a);
      const Eigen::VectorXd x = solved(a, b);
      CHECK(std::abs(x(at) - b(at)) <= 1e-15);
      CHECK(difference(x, expected.partialPivLu().solve(b)) <= 1e-14);
    }
  });
}

TEST_CASE("chain matrix: a symmetrically pinned unknown leaves all equations but its own") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    for (const double diagonal : {1.0, 0.0}) {
      ChainMatrix a = random.matrix(block, with_update);
      const auto at = static_cast<Eigen::Index>(3 * block + 1);
      Eigen::MatrixXd expected = dense(a);
      expected.row(at).setZero();
      expected.col(at).setZero();
      expected(at, at) = diagonal;
      a.pin(static_cast<std::size_t>(at), diagonal);
      CHECK(difference(dense(a), expected) <= 0);
    }
  });
}

TEST_CASE("chain matrix: its symmetric part is that of the full matrix where the update is symmetric already") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    ChainMatrix a = random.matrix(block, with_update);
    if (with_update) a.update()->column = -1.7 * a.update()->row;
    const Eigen::MatrixXd expected = 0.5 * (dense(a) + dense(a).transpose());
    a.make_symmetric();
    CHECK(difference(dense(a), expected) <= 1e-14);
  });
}

TEST_CASE("chain matrix: the symmetric part of any update is symmetric and alike along its row") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    if (!with_update) return;
    ChainMatrix a = random.matrix(block, true);
    const Eigen::VectorXd row = a.update()->row;
    const double along = row.dot(dense(a) * row);
    a.make_symmetric();
    CHECK(difference(dense(a), dense(a).transpose()) <= 1e-15);
    CHECK(std::abs(row.dot(dense(a) * row) - along) <= 1e-12 * std::abs(along));
  });
}

TEST_CASE("chain matrix: what has no factors is refused with and without the update") {
  for_every_kind([](RandomChain& random, int block, bool with_update) {
    ChainMatrix a = random.matrix(block, with_update);
    ChainFactors factors;
    if (with_update) {
      // 1 + row . T^-1 column = 0 makes the sum singular although T is not.
      Eigen::VectorXd& column = a.update()->column;
      column = Eigen::VectorXd::Unit(column.size(), 0);
      a.update()->row = -Eigen::VectorXd::Unit(column.size(), 0);
      with_block_size(block, [&](auto B) {
        auto& t = a.as<B()>();
        t.set_zero();
        for (std::size_t i = 0; i < nodes; ++i) t.diagonal(i).setIdentity();
      });
      CHECK_FALSE(factors.factorize(a));
      a.update().reset();
      CHECK(factors.factorize(a));
      return;
    }
    with_block_size(block, [&](auto B) { a.as<B()>().diagonal(0).setZero(); });
    CHECK_FALSE(factors.factorize(a));
  });
}
