#include "strandyn/math/chain_matrix.hpp"

namespace strandyn::math {

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

}  // namespace strandyn::math
