#include "strandyn/math/chain_matrix.hpp"

#include <cmath>

#include "wide_blocks.hpp"

namespace strandyn::math {
namespace {

/// What a BlockTridiagonalLU keeps, which it shows to whoever archives it.
template <class F>
struct Kept {
  const F& f;
  template <class Blocks>
  void operator()(Blocks& inverse, Blocks& lower, Blocks& upper) const {
    f(inverse, lower, upper);
  }
};

/// The sums of BlockTridiagonalLU::factorize and solve; those of blocks of five and six in wide registers.
template <int B>
bool factorize_blocks(const BlockTridiagonal<B>& a, BlockTridiagonalLU<B>& factors) {
  if constexpr (B < 5) {
    return factors.factorize(a);
  } else {
    const std::size_t n = a.nodes();
    bool done = true;
    const auto eliminate = [&](auto& inverse, auto& lower, auto& upper) {
      using Block = typename BlockTridiagonal<B>::Block;
      for (auto* blocks : {&inverse, &lower, &upper}) blocks->resize(n, Block::Zero());
      for (std::size_t i = 0; i + 1 < n; ++i) upper[i] = a.upper(i);
      const double* below = n > 1 ? a.lower(0).data() : nullptr;
      done = n == 0 || wide_blocks::eliminate<B>({n, a.diagonal(0).data(), upper[0].data(), below}, inverse[0].data(),
                                                 lower[0].data());
    };
    factors.archive(Kept<decltype(eliminate)>{eliminate});
    return done;
  }
}

template <int B>
void solve_blocks(const BlockTridiagonalLU<B>& factors, double* x) {
  if constexpr (B < 5) {
    factors.solve(x);
  } else {
    const auto substitute = [x](const auto& inverse, const auto& lower, const auto& upper) {
      if (inverse.empty()) return;
      wide_blocks::substitute<B>(inverse.size(), inverse[0].data(), lower[0].data(), upper[0].data(), x);
    };
    // Shown to an archive, they are not changed.
    const_cast<BlockTridiagonalLU<B>&>(factors).archive(Kept<decltype(substitute)>{substitute});
  }
}

}  // namespace

ChainMatrix::ChainMatrix(int block, std::size_t nodes) : block_(block) {
  with_block_size(block, [&](auto B) { blocks_ = BlockTridiagonal<B()>(nodes); });
}

std::size_t ChainMatrix::nodes() const {
  return std::visit([](const auto& t) { return t.nodes(); }, blocks_);
}

void ChainMatrix::set_zero() {
  std::visit([](auto& t) { t.set_zero(); }, blocks_);
  update_.reset();
}

void ChainMatrix::add(double factor, const ChainMatrix& other) {
  with_block_size(block_, [&](auto B) {
    auto& mine = as<B()>();
    const auto& theirs = other.as<B()>();
    for (std::size_t i = 0; i < mine.nodes(); ++i) {
      mine.diagonal(i) += factor * theirs.diagonal(i);
      if (i + 1 == mine.nodes()) break;
      mine.upper(i) += factor * theirs.upper(i);
      mine.lower(i) += factor * theirs.lower(i);
    }
  });
  if (!other.update_) return;
  update_ = other.update_;
  update_->column *= factor;
}

void ChainMatrix::add_at_node(std::size_t i, std::size_t j, double value) {
  const auto B = static_cast<std::size_t>(block_);
  std::visit([&](auto& t) { t.diagonal(i / B)(static_cast<int>(i % B), static_cast<int>(j % B)) += value; }, blocks_);
}

void ChainMatrix::pin_row(std::size_t i) {
  const auto B = static_cast<std::size_t>(block_);
  std::visit([&](auto& t) { t.pin_row(i / B, static_cast<int>(i % B)); }, blocks_);
  if (update_) update_->column(static_cast<Eigen::Index>(i)) = 0;
}

void ChainMatrix::pin(std::size_t i, double diagonal) {
  const auto B = static_cast<std::size_t>(block_);
  std::visit(
      [&](auto& t) {
        const int row = static_cast<int>(i % B);
        t.pin(i / B, row);
        t.diagonal(i / B)(row, row) = diagonal;
      },
      blocks_);
  if (!update_) return;
  update_->column(static_cast<Eigen::Index>(i)) = 0;
  update_->row(static_cast<Eigen::Index>(i)) = 0;
}

void ChainMatrix::make_symmetric() {
  std::visit(
      [](auto& t) {
        for (std::size_t i = 0; i < t.nodes(); ++i) {
          t.diagonal(i) = 0.5 * (t.diagonal(i) + t.diagonal(i).transpose()).eval();
          if (i + 1 == t.nodes()) break;
          const auto mean = (0.5 * (t.upper(i) + t.lower(i).transpose())).eval();
          t.upper(i) = mean;
          t.lower(i) = mean.transpose();
        }
      },
      blocks_);
  if (!update_) return;
  // Of a b^T the symmetric part has rank two; along its own row it is that of (b.a/b.b) b b^T.
  const double size = update_->row.squaredNorm();
  if (size > 0) update_->column = update_->row * (update_->row.dot(update_->column) / size);
}

void ChainMatrix::multiply(const double* x, double* y) const {
  std::visit([&](const auto& t) { t.multiply(x, y); }, blocks_);
  if (!update_) return;
  const auto n = static_cast<Eigen::Index>(size());
  Eigen::Map<Eigen::VectorXd>(y, n) += update_->column * update_->row.dot(Eigen::Map<const Eigen::VectorXd>(x, n));
}

bool ChainMatrix::fits_update() const {
  const auto n = static_cast<Eigen::Index>(size());
  return !update_ || (update_->column.size() == n && update_->row.size() == n);
}

std::size_t negative_eigenvalues(const ChainMatrix& a) {
  const auto of_blocks = [&](auto B) {
    using Blocks = BlockTridiagonal<B()>;
    const Blocks& t = a.as<B()>();
    std::size_t count = 0;
    typename Blocks::Block pivot = Blocks::Block::Zero();
    for (std::size_t i = 0; i < t.nodes(); ++i) {
      if (i > 0) pivot = (t.lower(i - 1) * pivot.partialPivLu().solve(t.upper(i - 1))).eval();
      pivot = (t.diagonal(i) - pivot).eval();
      const Eigen::SelfAdjointEigenSolver<typename Blocks::Block> eigen(pivot, Eigen::EigenvaluesOnly);
      count += static_cast<std::size_t>((eigen.eigenvalues().array() < 0).count());
    }
    return count;
  };
  const std::size_t count = with_block_size(a.block(), of_blocks);
  if (!a.update()) return count;
  // A = T + s b b^T moves at most one eigenvalue across zero; the determinant det(T) (1 + row . T^-1 column) tells.
  ChainMatrix blocks = a;
  blocks.update().reset();
  ChainFactors factors;
  if (!factors.factorize(blocks)) return count;
  Eigen::VectorXd solved = a.update()->column;
  factors.solve(solved.data());
  if (1 + a.update()->row.dot(solved) >= 0) return count;
  return a.update()->row.dot(a.update()->column) > 0 ? count - 1 : count + 1;
}

bool ChainFactors::factorize(const ChainMatrix& a) {
  const bool done = with_block_size(a.block(), [&](auto B) {
    using Factors = BlockTridiagonalLU<B()>;
    if (!std::holds_alternative<Factors>(factors_)) factors_ = Factors();
    return factorize_blocks<B()>(a.as<B()>(), std::get<Factors>(factors_));
  });
  updated_ = a.update().has_value();
  if (!done || !updated_) return done;
  row_ = a.update()->row;
  solved_column_ = a.update()->column;
  std::visit([&](const auto& f) { solve_blocks(f, solved_column_.data()); }, factors_);
  const double pivot = 1 + row_.dot(solved_column_);
  solved_column_ /= pivot;
  return std::isfinite(pivot) && pivot != 0;
}

void ChainFactors::solve(double* x) const {
  std::visit([&](const auto& f) { solve_blocks(f, x); }, factors_);
  if (!updated_) return;
  Eigen::Map<Eigen::VectorXd> solution(x, row_.size());
  solution -= solved_column_ * row_.dot(solution);
}

bool ChainFactors::fit(const ChainMatrix& a) const {
  const auto size = static_cast<Eigen::Index>(a.size());
  return factors_.index() + 2 == static_cast<std::size_t>(a.block()) &&
         std::visit([&](const auto& f) { return f.fit(a.nodes()); }, factors_) &&
         (!updated_ || (row_.size() == size && solved_column_.size() == size));
}

}  // namespace strandyn::math
