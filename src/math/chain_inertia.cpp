#include "strandyn/math/chain_matrix.hpp"

namespace strandyn::math {

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

}  // namespace strandyn::math
