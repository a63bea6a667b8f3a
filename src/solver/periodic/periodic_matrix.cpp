#include "periodic_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

HarmonicMatrix::HarmonicMatrix(int block, std::size_t nodes, Index coefficients)
    : block_(block),
      coefficients_(coefficients),
      width_(block * coefficients),
      diagonal_(nodes, MatrixXd::Zero(width_, width_)),
      upper_(nodes - 1, MatrixXd::Zero(width_, width_)),
      lower_(upper_) {}

void HarmonicMatrix::set_zero() {
  for (auto* blocks : {&diagonal_, &upper_, &lower_}) {
    for (MatrixXd& block : *blocks) block.setZero();
  }
}

template <class Block>
void HarmonicMatrix::add_block(MatrixXd& mine, const MatrixXd& factors, const Block& theirs) const {
  for (Index b = 0; b < coefficients_; ++b) {
    for (Index a = 0; a < coefficients_; ++a) {
      if (factors(a, b) != 0) mine.block(a * block_, b * block_, block_, block_) += factors(a, b) * theirs;
    }
  }
}

void HarmonicMatrix::add(const MatrixXd& factors, const math::ChainMatrix& k) {
  math::with_block_size(block_, [&](auto B) {
    const auto& blocks = k.as<B()>();
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      add_block(diagonal_[i], factors, blocks.diagonal(i));
      if (i + 1 == diagonal_.size()) break;
      add_block(upper_[i], factors, blocks.upper(i));
      add_block(lower_[i], factors, blocks.lower(i));
    }
  });
}

void HarmonicMatrix::add_element(const MatrixXd& factors, const math::ChainMatrix& k, std::size_t i) {
  math::with_block_size(block_, [&](auto B) {
    const auto& blocks = k.as<B()>();
    add_block(diagonal_[i], factors, blocks.diagonal(i));
    add_block(upper_[i], factors, blocks.upper(i));
    add_block(lower_[i], factors, blocks.lower(i));
    add_block(diagonal_[i + 1], factors, blocks.diagonal(i + 1));
  });
}

void CycleMatrix::set(Index sample, const math::ChainMatrix& k) {
  math::with_block_size(block_, [&](auto B) {
    const auto& blocks = k.as<B()>();
    double* at = samples_.col(sample).data();
    const auto put = [&](const auto& block) {
      const Eigen::Index size = block.size();
      std::copy(block.data(), block.data() + size, at);
      at += size;
    };
    for (std::size_t i = 0; i < k.nodes(); ++i) {
      put(blocks.diagonal(i));
      if (i + 1 == k.nodes()) break;
      put(blocks.upper(i));
      put(blocks.lower(i));
    }
  });
}

void HarmonicMatrix::add(const CycleMatrix& k) {
  // cos cos, sin sin, cos sin of harmonics p, q are halves of sums over p + q and p - q; so 4 H + 1 means of an entry
  // make all its (2 H + 1)^2 coefficients.
  const MatrixXd means = k.samples_ * k.fourier_.products();  // entries by means
  const auto of_cosine = [](Index n) { return n == 0 ? 0 : 2 * n - 1; };
  const auto of_sine = [](Index n) { return 2 * n; };
  Index first = 0;
  const auto add_entries = [&](MatrixXd& mine) {
    const auto term = [&](Index a, Index b, double factor, Index column) {
      const double* block = &means(first, column);
      mine.block(a * block_, b * block_, block_, block_) += factor * Eigen::Map<const MatrixXd>(block, block_, block_);
    };
    term(0, 0, 1, 0);
    for (Index p = 1; 2 * p < coefficients_; ++p) {
      const Index cosine = 2 * p - 1;
      const Index sine = 2 * p;
      term(0, cosine, 1, of_cosine(p));
      term(0, sine, 1, of_sine(p));
      term(cosine, 0, 2, of_cosine(p));
      term(sine, 0, 2, of_sine(p));
      for (Index q = 1; 2 * q < coefficients_; ++q) {
        const Index difference = std::abs(p - q);
        term(cosine, 2 * q - 1, 1, of_cosine(difference));
        term(cosine, 2 * q - 1, 1, of_cosine(p + q));
        term(sine, 2 * q, 1, of_cosine(difference));
        term(sine, 2 * q, -1, of_cosine(p + q));
        term(cosine, 2 * q, 1, of_sine(p + q));
        term(sine, 2 * q - 1, 1, of_sine(p + q));
        if (p == q) continue;
        const double sign = p > q ? 1 : -1;
        term(cosine, 2 * q, -sign, of_sine(difference));
        term(sine, 2 * q - 1, sign, of_sine(difference));
      }
    }
    first += block_ * block_;
  };
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    add_entries(diagonal_[i]);
    if (i + 1 == diagonal_.size()) break;
    add_entries(upper_[i]);
    add_entries(lower_[i]);
  }
}

Eigen::RowVectorXd HarmonicMatrix::row(Index place) const {
  const auto node = static_cast<std::size_t>(place / width_);
  const Index r = place % width_;
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size());
  const Index first = place - r;
  row.segment(first, width_) = diagonal_[node].row(r);
  if (node > 0) row.segment(first - width_, width_) = lower_[node - 1].row(r);
  if (node + 1 < diagonal_.size()) row.segment(first + width_, width_) = upper_[node].row(r);
  return row;
}

void HarmonicMatrix::pin_row(Index place) {
  const auto node = static_cast<std::size_t>(place / width_);
  const Index r = place % width_;
  diagonal_[node].row(r).setZero();
  diagonal_[node](r, r) = 1;
  if (node > 0) lower_[node - 1].row(r).setZero();
  if (node + 1 < diagonal_.size()) upper_[node].row(r).setZero();
}

VectorXd HarmonicMatrix::pack(const MatrixXd& rows) const {
  VectorXd x(size());
  for (Index i = 0; i < rows.rows(); ++i) {
    for (Index a = 0; a < coefficients_; ++a) x(place(static_cast<std::size_t>(i), a)) = rows(i, a);
  }
  return x;
}

MatrixXd HarmonicMatrix::unpack(const VectorXd& x) const {
  MatrixXd rows(x.size() / coefficients_, coefficients_);
  for (Index i = 0; i < rows.rows(); ++i) {
    for (Index a = 0; a < coefficients_; ++a) rows(i, a) = x(place(static_cast<std::size_t>(i), a));
  }
  return rows;
}

bool HarmonicFactors::factorize(const HarmonicMatrix& a) {
  const std::size_t nodes = a.diagonal_.size();
  pivot_.resize(nodes);
  scale_.resize(nodes);
  lower_ = a.lower_;
  upper_ = a.upper_;
  MatrixXd carried;  // pivot^-1 upper of the node before
  for (std::size_t i = 0; i < nodes; ++i) {
    MatrixXd pivot = a.diagonal_[i];
    if (i > 0) pivot.noalias() -= lower_[i - 1] * upper_[i - 1];
    // Rows and columns brought to like size: a block mixes forces and moments.
    scale_[i] = pivot.diagonal().cwiseAbs().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
    pivot_[i].compute(scale_[i].asDiagonal() * pivot * scale_[i].asDiagonal());
    if (!pivot_[i].matrixLU().allFinite() || pivot_[i].matrixLU().diagonal().cwiseAbs().minCoeff() == 0) return false;
    if (i + 1 == nodes) break;
    upper_[i] = (scale_[i].asDiagonal() * pivot_[i].solve(scale_[i].asDiagonal() * upper_[i])).eval();
  }
  return true;
}

void HarmonicFactors::solve(MatrixXd& x) const {
  const Index width = scale_.front().size();
  const auto at = [&](std::size_t i) { return x.middleRows(static_cast<Index>(i) * width, width); };
  for (std::size_t i = 0; i < pivot_.size(); ++i) {
    if (i > 0) at(i).noalias() -= lower_[i - 1] * at(i - 1);
    at(i) = (scale_[i].asDiagonal() * pivot_[i].solve(scale_[i].asDiagonal() * at(i))).eval();
  }
  for (std::size_t i = pivot_.size() - 1; i-- > 0;) at(i).noalias() -= upper_[i] * at(i + 1);
}

bool solve_bordered(const HarmonicFactors& factors, const Border& border, MatrixXd& x, MatrixXd& y) {
  MatrixXd columns = border.columns;
  factors.solve(columns);
  factors.solve(x);
  MatrixXd complement = border.corner - border.rows * columns;
  MatrixXd right = y - border.rows * x;
  for (Index r = 0; r < complement.rows(); ++r) {
    const double size = complement.row(r).cwiseAbs().maxCoeff();
    if (!(size > 0)) return false;
    complement.row(r) /= size;
    right.row(r) /= size;
  }
  // Columns are as unlike in size as a swing and a frequency: brought to one, then solved.
  const VectorXd sizes = complement.cwiseAbs().colwise().maxCoeff();
  if (!(sizes.minCoeff() > 0)) return false;
  complement = complement * sizes.cwiseInverse().asDiagonal();
  y = sizes.cwiseInverse().asDiagonal() * complement.fullPivLu().solve(right);
  x -= columns * y;
  return x.allFinite() && y.allFinite();
}

}  // namespace strandyn::solver
