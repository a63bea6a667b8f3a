#pragma once
/// \file The matrix of a chain whose number of unknowns per node, 2 to 6, is known at run time only.
///
///     A = T + column row^T
/// T is block-tridiagonal; the optional update of rank one couples all nodes, as a tension does that is the same along
/// the span. Solved with the factors of T and the formula of Sherman and Morrison:
///     A^-1 b = x - y (row . x)/(1 + row . y),   T x = b,   T y = column

#include <optional>
#include <variant>

#include "strandyn/math/block_tridiagonal.hpp"

namespace strandyn::math {

/// Calls `f` with std::integral_constant<int, B> for the block size B. Asserts 2 <= block <= 6.
template <class F>
decltype(auto) with_block_size(int block, F&& f) {
  switch (block) {
    case 2:
      return f(std::integral_constant<int, 2>{});
    case 3:
      return f(std::integral_constant<int, 3>{});
    case 4:
      return f(std::integral_constant<int, 4>{});
    case 5:
      return f(std::integral_constant<int, 5>{});
    default:
      return f(std::integral_constant<int, 6>{});
  }
}

class ChainMatrix {
 public:
  struct RankOne {
    Eigen::VectorXd column, row;

    template <class Archive>
    void archive(Archive& a) {
      a(column, row);
    }
  };

  /// All zero, without the update.
  ChainMatrix(int block, std::size_t nodes);

  int block() const { return block_; }
  std::size_t nodes() const;
  std::size_t size() const { return nodes() * static_cast<std::size_t>(block_); }

  /// T, for whoever knows B.
  template <int B>
  BlockTridiagonal<B>& as() {
    return std::get<BlockTridiagonal<B>>(blocks_);
  }
  template <int B>
  const BlockTridiagonal<B>& as() const {
    return std::get<BlockTridiagonal<B>>(blocks_);
  }
  std::optional<RankOne>& update() { return update_; }
  const std::optional<RankOne>& update() const { return update_; }

  void set_zero();
  /// A += factor * other. Only one of the two may carry an update, and `factor` scales it.
  void add(double factor, const ChainMatrix& other);
  /// Adds to the entry of two unknowns of one node; both count from 0 over the whole chain.
  void add_at_node(std::size_t i, std::size_t j, double value);
  /// Makes equation i read x = right-hand side.
  void pin_row(std::size_t i);
  /// The same, symmetrically; the diagonal entry becomes `diagonal`.
  void pin(std::size_t i, double diagonal = 1);
  void make_symmetric();
  /// y = A x.
  void multiply(const double* x, double* y) const;

  /// Whether the update is one of this matrix; what is read from a file need not be.
  bool fits_update() const;

  /// Keeps its block size.
  template <class Archive>
  void archive(Archive& a) {
    std::visit([&](auto& blocks) { a(blocks); }, blocks_);
    a(update_);
  }

 private:
  int block_;
  std::variant<BlockTridiagonal<2>, BlockTridiagonal<3>, BlockTridiagonal<4>, BlockTridiagonal<5>, BlockTridiagonal<6>>
      blocks_;
  std::optional<RankOne> update_;
};

/// How many eigenvalues of a symmetric matrix are negative, by the inertia of its pivot blocks (Haynsworth).
std::size_t negative_eigenvalues(const ChainMatrix& a);

/// The factors of a ChainMatrix. Keeps its storage from one factorization to the next.
class ChainFactors {
 public:
  /// False where the matrix has no factors without exchanging nodes.
  bool factorize(const ChainMatrix& a);
  /// Overwrites the right-hand side with the solution.
  void solve(double* x) const;

  /// Whether these are the factors of a matrix with the blocks, nodes and update of `a`; what is read from a file need
  /// not be of any.
  bool fit(const ChainMatrix& a) const;

  template <class Archive>
  void archive(Archive& a) {
    std::size_t kind = factors_.index();
    a(kind);
    if (kind != factors_.index()) {
      with_block_size(static_cast<int>(kind) + 2, [&](auto B) { factors_ = BlockTridiagonalLU<B()>(); });
    }
    std::visit([&](auto& factors) { a(factors); }, factors_);
    a(updated_, row_, solved_column_);
  }

 private:
  std::variant<BlockTridiagonalLU<2>, BlockTridiagonalLU<3>, BlockTridiagonalLU<4>, BlockTridiagonalLU<5>,
               BlockTridiagonalLU<6>>
      factors_;
  bool updated_ = false;
  Eigen::VectorXd row_, solved_column_;  // solved_column = y/(1 + row . y)
};

}  // namespace strandyn::math
