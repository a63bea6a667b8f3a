#pragma once
/// \file The chain as IDA sees it: residual, matrix of the implicit step and its solution by eliminating u' = v.
///
///     [cj I, -I; K, G] (du, dv) = (b1, b2),  G = cj M + C   =>   (K + cj G) du = b2 + G b1,   dv = cj du - b1
/// Only K + cj G, block-tridiagonal over the nodes, is factored.

#include "strandyn/system/system.hpp"

namespace strandyn::solver {

class ChainProblem {
 public:
  explicit ChainProblem(system::System& system, std::span<const model::Drive> drives = {});

  std::size_t unknowns() const { return system_.unknowns(); }
  std::string unknown_name(std::size_t i) const { return system_.model().unknown_name(i); }

  /// F(t, y, y'), each of length 2 * unknowns: first u, then v. `with_tangent`: `refresh` will follow, so the law is
  /// asked once for force and tangent.
  void residual(double t, const double* y, const double* yp, double* f, bool with_tangent);
  /// Factors the matrix at the state of the last residual. False where it is singular.
  bool refresh(double cj);
  /// Solves J x = b with the factors at hand.
  void solve(const double* b, double* x);

  double factored_cj() const { return cj_; }

  /// The factors at hand, and what `solve` needs beside them. They were made at a state and a history of long ago.
  /// Throws FileError where they are another system's.
  void archive(Archive& a);

 private:
  system::At at(double t) const { return {.time = t, .drives = drives_}; }

  system::System& system_;
  std::vector<model::Drive> drives_;
  system::Vector scratch_;
  system::Vector u_, v_, a_;  // state of the last residual
  system::Matrix K_, G_;
  math::ChainFactors factors_;
  double time_ = 0;                   // of the last residual
  system::Vector held_, held_rates_;  // what prescribed motions say; zero for all others
  system::Vector right_side_, product_;
  double cj_ = 0;
  bool tangent_at_hand_ = false;  // K_ is the chain's at the state of the last residual
};

}  // namespace strandyn::solver
