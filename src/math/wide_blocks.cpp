#include "strandyn/math/block_tridiagonal.hpp"
#include "wide_blocks_kernel.hpp"

namespace strandyn::math::wide_blocks {
namespace {

/// As the factors of a chain of one node. What is singular gives numbers that are not finite.
template <int B>
void invert(const double* a, double* inverse) {
  using Block = Eigen::Matrix<double, B, B>;
  BlockTridiagonal<B> one(1);
  one.diagonal(0) = Eigen::Map<const Block>(a);
  BlockTridiagonalLU<B> factors;
  factors.factorize(one);
  Eigen::Map<Block>{inverse}.setIdentity();
  for (int c = 0; c < B; ++c) factors.solve(inverse + B * c);
}

}  // namespace

void invert_with_exchanges(int B, const double* a, double* inverse) {
  B == 5 ? invert<5>(a, inverse) : invert<6>(a, inverse);
}

}  // namespace strandyn::math::wide_blocks
