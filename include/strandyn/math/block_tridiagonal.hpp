#pragma once
/// \file Systems whose matrix couples each node of a chain to its two neighbours only.
///
/// Blocks of B x B: A_ii on the diagonal, A_i,i+1 and A_i+1,i beside it; the matrix need not be symmetric. Block LU
/// without exchange of nodes: right for the matrices of a chain, M c^2 + C c + K and K at a stable state, whose leading
/// blocks are definite. Cost: linear in the number of nodes.

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace strandyn::math {

template <int B>
class BlockTridiagonal {
 public:
  using Block = Eigen::Matrix<double, B, B>;
  using Vector = Eigen::Matrix<double, B, 1>;

  /// All zero.
  explicit BlockTridiagonal(std::size_t nodes = 0)
      : diagonal_(nodes, Block::Zero()), upper_(nodes ? nodes - 1 : 0, Block::Zero()), lower_(upper_) {}

  std::size_t nodes() const { return diagonal_.size(); }
  Block& diagonal(std::size_t i) { return diagonal_[i]; }
  Block& upper(std::size_t i) { return upper_[i]; }  ///< couples node i to i + 1
  Block& lower(std::size_t i) { return lower_[i]; }  ///< couples node i + 1 to i
  const Block& diagonal(std::size_t i) const { return diagonal_[i]; }
  const Block& upper(std::size_t i) const { return upper_[i]; }
  const Block& lower(std::size_t i) const { return lower_[i]; }

  void set_zero() {
    for (Block& b : diagonal_) b.setZero();
    for (Block& b : upper_) b.setZero();
    for (Block& b : lower_) b.setZero();
  }

  /// Adds a 2B x 2B matrix that couples nodes i and i + 1.
  template <class Matrix>
  void add_element(std::size_t i, const Matrix& k) {
    diagonal_[i] += k.template topLeftCorner<B, B>();
    upper_[i] += k.template topRightCorner<B, B>();
    lower_[i] += k.template bottomLeftCorner<B, B>();
    diagonal_[i + 1] += k.template bottomRightCorner<B, B>();
  }

  /// Makes equation `row` of node i read x = right-hand side, and takes the unknown out of all others: a support.
  void pin(std::size_t i, int row) {
    diagonal_[i].row(row).setZero();
    diagonal_[i].col(row).setZero();
    diagonal_[i](row, row) = 1;
    if (i > 0) {
      lower_[i - 1].row(row).setZero();
      upper_[i - 1].col(row).setZero();
    }
    if (i + 1 < nodes()) {
      upper_[i].row(row).setZero();
      lower_[i].col(row).setZero();
    }
  }

  /// y = A x.
  void multiply(const double* x, double* y) const {
    for (std::size_t i = 0; i < nodes(); ++i) {
      Vector sum = diagonal_[i] * node(x, i);
      if (i > 0) sum += lower_[i - 1] * node(x, i - 1);
      if (i + 1 < nodes()) sum += upper_[i] * node(x, i + 1);
      node(y, i) = sum;
    }
  }

 private:
  static Eigen::Map<const Vector> node(const double* x, std::size_t i) { return Eigen::Map<const Vector>(x + i * B); }
  static Eigen::Map<Vector> node(double* x, std::size_t i) { return Eigen::Map<Vector>(x + i * B); }

  std::vector<Block> diagonal_, upper_, lower_;
};

/// The factors of a BlockTridiagonal. Keeps its storage from one factorization to the next.
template <int B>
class BlockTridiagonalLU {
 public:
  using Block = typename BlockTridiagonal<B>::Block;
  using Vector = typename BlockTridiagonal<B>::Vector;

  /// False where a pivot block is singular: the matrix has no factors without exchanging nodes.
  bool factorize(const BlockTridiagonal<B>& a) {
    const std::size_t n = a.nodes();
    inverse_.resize(n);
    lower_.resize(n);
    upper_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      Block pivot = a.diagonal(i);
      if (i > 0) {
        lower_[i].noalias() = a.lower(i - 1) * inverse_[i - 1];
        pivot.noalias() -= lower_[i] * a.upper(i - 1);
      }
      if (i + 1 < n) upper_[i] = a.upper(i);
      inverse_[i] = inverse(pivot);
      if (!inverse_[i].allFinite()) return false;
    }
    return true;
  }

  /// Overwrites the right-hand side with the solution.
  void solve(double* x) const {
    const std::size_t n = inverse_.size();
    for (std::size_t i = 1; i < n; ++i) node(x, i).noalias() -= lower_[i] * node(x, i - 1);
    for (std::size_t i = n; i-- > 0;) {
      Vector y = node(x, i);
      if (i + 1 < n) y.noalias() -= upper_[i] * node(x, i + 1);
      node(x, i).noalias() = inverse_[i] * y;
    }
  }

 private:
  /// Inverse with rows and columns brought to like size first: a block mixes forces and moments.
  static Block inverse(const Block& pivot) {
    Vector scale;
    for (int r = 0; r < B; ++r) {
      const double size = std::abs(pivot(r, r));
      scale(r) = size > 0 ? 1 / std::sqrt(size) : 1;
    }
    const Block scaled = scale.asDiagonal() * pivot * scale.asDiagonal();
    Block result;
    if constexpr (B <= 4) {
      result = scaled.inverse();
    } else {
      result = scaled.partialPivLu().inverse();
    }
    return scale.asDiagonal() * result * scale.asDiagonal();
  }
  static Eigen::Map<Vector> node(double* x, std::size_t i) { return Eigen::Map<Vector>(x + i * B); }

  std::vector<Block> inverse_, lower_, upper_;
};

}  // namespace strandyn::math
