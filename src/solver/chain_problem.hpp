#pragma once
/// \file The chain as IDA sees it: residual, matrix of the implicit step and its solution by eliminating u' = v.
///
///     [cj I, -I; K, G] (du, dv) = (b1, b2),  G = cj M + C   =>   (K + cj G) du = b2 + G b1,   dv = cj du - b1
/// Only K + cj G, block-tridiagonal over the nodes, is factored.

#include "strandyn/system/system.hpp"

namespace strandyn::solver {

class ChainProblem {
 public:
  explicit ChainProblem(system::System& system);

  std::size_t unknowns() const { return system_.unknowns(); }

  /// F(t, y, y'), each of length 2 * unknowns: first u, then v.
  void residual(double t, const double* y, const double* yp, double* f);
  /// Factors the matrix at the state of the last residual.
  void refresh(double cj);
  /// Solves J x = b with the factors at hand. b is zero for held unknowns, as their residual is: they never move.
  void solve(const double* b, double* x);

  double factored_cj() const { return cj_; }

 private:
  system::System& system_;
  system::Vector external_, internal_;
  system::Vector u_, v_, a_;  // state of the last residual
  system::Matrix K_, G_;
  math::BlockTridiagonalLU<static_cast<int>(model::unknowns_per_node)> factors_;
  system::Vector right_side_, product_;
  double cj_ = 0;
};

}  // namespace strandyn::solver
