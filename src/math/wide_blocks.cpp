#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wide_blocks_kernel.hpp"

namespace strandyn::math::wide_blocks {
namespace {

/// In place, by columns. A block mixes forces and moments: rows are brought to like size where a pivot is chosen.
template <int B>
void gauss_jordan(const double* from, double* to) {
  Eigen::Matrix<double, B, B> a = Eigen::Map<const Eigen::Matrix<double, B, B>>(from);
  Eigen::Matrix<double, B, 1> size;
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
    Eigen::Matrix<double, B, 1> column = -pivot * a.col(k);
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
  std::copy_n(a.data(), B * B, to);
}

}  // namespace

void invert_with_exchanges(int B, const double* a, double* inverse) {
  B == 5 ? gauss_jordan<5>(a, inverse) : gauss_jordan<6>(a, inverse);
}

}  // namespace strandyn::math::wide_blocks
