#pragma once
/// \file The matrix of Newton's method for all harmonics of a chain: neighbouring nodes couple, with all harmonics of
/// their unknowns, and a few equations and unknowns border it.
///
///     [ T  B ] [x]   [f]
///     [ E  D ] [y] = [g]
/// T is block-tridiagonal with blocks of (unknowns per node) x (coefficients).

#include <Eigen/Dense>
#include <vector>

#include "periodic_fourier.hpp"
#include "strandyn/math/chain_matrix.hpp"

namespace strandyn::solver {

class CycleMatrix;

class HarmonicMatrix {
 public:
  HarmonicMatrix(int block, std::size_t nodes, Eigen::Index coefficients);

  Eigen::Index size() const { return static_cast<Eigen::Index>(diagonal_.size()) * width_; }
  /// Place of coefficient `a` of unknown `i`.
  Eigen::Index place(std::size_t i, Eigen::Index a) const {
    const auto unknown = static_cast<Eigen::Index>(i);
    return unknown / block_ * width_ + a * block_ + unknown % block_;
  }
  void set_zero();
  /// Coefficient a of the equations changes by factors(a, b) k times coefficient b of the unknowns; without the update
  /// of rank one of k.
  void add(const Eigen::MatrixXd& factors, const math::ChainMatrix& k);
  /// The same of one element, which joins nodes i and i + 1, where it is alone in k.
  void add_element(const Eigen::MatrixXd& factors, const math::ChainMatrix& k, std::size_t i);
  /// What a matrix that changes along the cycle does to harmonics: sum_j projection_j k_j basis_j.
  void add(const CycleMatrix& k);
  /// The equation at a place, as a row over all unknowns.
  Eigen::RowVectorXd row(Eigen::Index place) const;
  /// Makes the equation read x = right-hand side.
  void pin_row(Eigen::Index place);

  /// Unknowns by coefficients as a vector of this order, and back.
  Eigen::VectorXd pack(const Eigen::MatrixXd& rows) const;
  Eigen::MatrixXd unpack(const Eigen::VectorXd& x) const;

 private:
  friend class HarmonicFactors;
  template <class Block>
  void add_block(Eigen::MatrixXd& mine, const Eigen::MatrixXd& factors, const Block& theirs) const;
  int block_;
  Eigen::Index coefficients_, width_;
  std::vector<Eigen::MatrixXd> diagonal_, upper_, lower_;
};

/// Samples of a chain's matrix around a cycle, without their updates of rank one.
class CycleMatrix {
 public:
  CycleMatrix(const Fourier& fourier, int block, std::size_t nodes)
      : fourier_(fourier), block_(block), samples_(entries(block, nodes), fourier.samples()) {}
  void set(Eigen::Index sample, const math::ChainMatrix& k);

 private:
  friend class HarmonicMatrix;
  static Eigen::Index entries(int block, std::size_t nodes) {
    return static_cast<Eigen::Index>(3 * nodes - 2) * block * block;
  }
  const Fourier& fourier_;
  int block_;
  Eigen::MatrixXd samples_;  // entries by samples: per node its diagonal block, the one above, the one below
};

class HarmonicFactors {
 public:
  /// False where a pivot block is singular.
  bool factorize(const HarmonicMatrix& a);
  /// Overwrites right-hand sides with solutions.
  void solve(Eigen::MatrixXd& x) const;

 private:
  std::vector<Eigen::MatrixXd> lower_, upper_;
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXd>> pivot_;
  std::vector<Eigen::VectorXd> scale_;
};

struct Border {
  Border(Eigen::Index size, Eigen::Index count)
      : columns(Eigen::MatrixXd::Zero(size, count)),
        rows(Eigen::MatrixXd::Zero(count, size)),
        corner(Eigen::MatrixXd::Zero(count, count)) {}
  Eigen::MatrixXd columns, rows, corner;  // B, E, D
};

/// Solves for several right-hand sides; overwrites them with the solutions. False where the whole is singular.
bool solve_bordered(const HarmonicFactors& factors, const Border& border, Eigen::MatrixXd& x, Eigen::MatrixXd& y);

}  // namespace strandyn::solver
