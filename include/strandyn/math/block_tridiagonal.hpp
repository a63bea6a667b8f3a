#pragma once
/// \file Systems whose matrix couples each node of a chain to its two neighbours only.
///
/// Blocks of B x B: A_ii on the diagonal, A_i,i+1 and A_i+1,i beside it; the matrix need not be symmetric. Block LU
/// without exchange of nodes: right for the matrices of a chain, M c^2 + C c + K and K at a stable state, whose leading
/// blocks are definite. Cost: linear in the number of nodes.

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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

  /// Makes equation `row` of node i read x = right-hand side.
  void pin_row(std::size_t i, int row) {
    diagonal_[i].row(row).setZero();
    diagonal_[i](row, row) = 1;
    if (i > 0) lower_[i - 1].row(row).setZero();
    if (i + 1 < nodes()) upper_[i].row(row).setZero();
  }

  /// The same, and takes the unknown out of all other equations: the matrix stays symmetric.
  void pin(std::size_t i, int row) {
    diagonal_[i].col(row).setZero();
    pin_row(i, row);
    if (i > 0) upper_[i - 1].col(row).setZero();
    if (i + 1 < nodes()) lower_[i].col(row).setZero();
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

  template <class Archive>
  void archive(Archive& a) {
    a(diagonal_, upper_, lower_);
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
    lower_.resize(n, Block::Zero());  // the first lower and the last upper one are written to checkpoints, too
    upper_.resize(n, Block::Zero());
    // What is not finite stays so in every sum: one look at the end is enough.
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Block pivot = a.diagonal(i);
      if (i > 0) {
        lower_[i].noalias() = a.lower(i - 1) * inverse_[i - 1];
        pivot.noalias() -= lower_[i] * a.upper(i - 1);
      }
      if (i + 1 < n) upper_[i] = a.upper(i);
      inverse_[i] = inverse(pivot);
      sum += inverse_[i].sum();
    }
    return std::isfinite(sum);
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

  /// Whether these are the factors of a matrix of `nodes` nodes; what is read from a file need not be of any.
  bool fit(std::size_t nodes) const {
    return inverse_.size() == nodes && lower_.size() == nodes && upper_.size() == nodes;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(inverse_, lower_, upper_);
  }

 private:
  static Block inverse(const Block& pivot) {
    if constexpr (B <= 4) {
      return pivot.inverse();  // by cofactors, whose terms have all the same unit
    } else {
      return gauss_jordan(pivot);
    }
  }

  /// In place, by columns. A block mixes forces and moments: rows are brought to like size where a pivot is chosen.
  static Block gauss_jordan(Block a) {
    Vector size;
    for (int r = 0; r < B; ++r) size(r) = a(r, r) != 0 ? 1 / std::sqrt(std::abs(a(r, r))) : 1;
    std::array<int, B> exchanged;
    for (int k = 0; k < B; ++k) {
      int best = k;
      for (int r = k + 1; r < B; ++r) {
        if (std::abs(a(r, k)) * size(r) > std::abs(a(best, k)) * size(best)) best = r;
      }
      exchanged[static_cast<std::size_t>(k)] = best;
      if (best != k) {
        a.row(k).swap(a.row(best));
        std::swap(size(k), size(best));
      }
      const double pivot = 1 / a(k, k);
      Vector column = -pivot * a.col(k);
      column(k) = pivot;
      a.col(k).setZero();
      for (int c = 0; c < B; ++c) {
        const double factor = a(k, c);
        a(k, c) = 0;
        a.col(c) += factor * column;
      }
      a.col(k) = column;
    }
    for (int k = B; k-- > 0;) {
      const int other = exchanged[static_cast<std::size_t>(k)];
      if (other != k) a.col(k).swap(a.col(other));
    }
    return a;
  }
  static Eigen::Map<Vector> node(double* x, std::size_t i) { return Eigen::Map<Vector>(x + i * B); }

  std::vector<Block> inverse_, lower_, upper_;
};

}  // namespace strandyn::math
