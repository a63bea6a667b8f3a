#pragma once
/// \file Block-tridiagonal matrices written out in full, for tests.

#include "strandyn/math/chain_matrix.hpp"

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

/// With the update of rank one, where there is one.
inline Eigen::MatrixXd dense(const math::ChainMatrix& a) {
  Eigen::MatrixXd full = math::with_block_size(a.block(), [&](auto B) { return dense(a.as<B()>()); });
  if (a.update()) full += a.update()->column * a.update()->row.transpose();
  return full;
}

}  // namespace strandyn::test
