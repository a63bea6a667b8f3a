#pragma once
/// \file A block-tridiagonal matrix written out in full, for tests.

#include "strandyn/math/block_tridiagonal.hpp"

namespace strandyn::test {

template <int B>
Eigen::MatrixXd dense(const math::BlockTridiagonal<B>& a) {
  const auto nodes = static_cast<Eigen::Index>(a.nodes());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(nodes * B, nodes * B);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const auto node = static_cast<std::size_t>(i);
    full.block<B, B>(i * B, i * B) = a.diagonal(node);
    if (i + 1 == nodes) break;
    full.block<B, B>(i * B, (i + 1) * B) = a.upper(node);
    full.block<B, B>((i + 1) * B, i * B) = a.lower(node);
  }
  return full;
}

}  // namespace strandyn::test
