#include "strandyn/solver/modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using model::unknowns_per_node;
using system::Matrix;
using system::System;
using system::Vector;

namespace {

constexpr int block = static_cast<int>(unknowns_per_node);

/// y = (K - sigma M)^-1 x, as Spectra wants it.
class ShiftedInverse {
 public:
  using Scalar = double;

  ShiftedInverse(const Matrix& K, const Matrix& M, Eigen::Index size) : K_(K), M_(M), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  void set_shift(double sigma) {
    Matrix shifted = K_;
    for (std::size_t i = 0; i < shifted.nodes(); ++i) {
      shifted.diagonal(i) -= sigma * M_.diagonal(i);
      if (i + 1 < shifted.nodes()) {
        shifted.upper(i) -= sigma * M_.upper(i);
        shifted.lower(i) -= sigma * M_.lower(i);
      }
    }
    if (!factors_.factorize(shifted)) {
      throw ComputationError("the stiffness matrix is singular: the span is free to move; hold it by its supports");
    }
  }
  void perform_op(const double* x, double* y) const {
    std::copy(x, x + size_, y);
    factors_.solve(y);
  }

 private:
  const Matrix& K_;
  const Matrix& M_;
  Eigen::Index size_;
  math::BlockTridiagonalLU<block> factors_;
};

/// y = M x.
class MassProduct {
 public:
  using Scalar = double;

  MassProduct(const Matrix& M, Eigen::Index size) : M_(M), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  void perform_op(const double* x, double* y) const { M_.multiply(x, y); }

 private:
  const Matrix& M_;
  Eigen::Index size_;
};

void make_symmetric(Matrix& K) {
  for (std::size_t i = 0; i < K.nodes(); ++i) {
    K.diagonal(i) = 0.5 * (K.diagonal(i) + K.diagonal(i).transpose()).eval();
    if (i + 1 == K.nodes()) break;
    const Matrix::Block mean = 0.5 * (K.upper(i) + K.lower(i).transpose());
    K.upper(i) = mean;
    K.lower(i) = mean.transpose();
  }
}

/// Held unknowns take no part in the motion: no mass, unit stiffness.
void take_out_held(const System& system, Matrix& M) {
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (!system.is_held(i)) continue;
    const auto row = static_cast<int>(i % unknowns_per_node);
    M.pin(i / unknowns_per_node, row);
    M.diagonal(i / unknowns_per_node)(row, row) = 0;
  }
}

Mode scaled(double omega2, Vector shape) {
  double largest = 0;
  for (Eigen::Index i = 0; i < shape.size(); ++i) {
    const bool translation = i % block < 2;
    if (translation && std::abs(shape(i)) > std::abs(largest)) largest = shape(i);
  }
  shape /= largest;
  return {.frequency = std::sqrt(std::max(omega2, 0.0)) / (2 * std::numbers::pi),
          .shape = std::move(shape),
          .modal_mass = 1 / (largest * largest)};
}

bool is_transverse(const Vector& shape) {
  double along = 0;
  double across = 0;
  for (Eigen::Index i = 0; i < shape.size(); i += block) {
    along += shape(i) * shape(i);
    across += shape(i + 1) * shape(i + 1);
  }
  return across > along;
}

}  // namespace

std::vector<Mode> lowest_modes(const System& system, const Vector& u, std::size_t count) {
  const auto size = static_cast<Eigen::Index>(system.unknowns());
  Matrix K(system.model().nodes.size());
  Matrix M(system.model().nodes.size());
  Vector force(size);
  system.internal_force(u.data(), force.data(), K);
  system.mass_matrix(u.data(), M);
  make_symmetric(K);
  system.hold(K);
  take_out_held(system, M);

  std::size_t with_mass = 0;
  for (std::size_t i = 0; i < system.unknowns(); ++i) with_mass += system.has_mass(i);
  // The solver finds all modes but the highest.
  if (count >= with_mass || with_mass < 2) {
    throw ComputationError(
        fmt::format("{} modes were asked for, but the mesh has only {} unknowns with mass; "
                    "give more [span] elements",
                    count, with_mass));
  }
  ShiftedInverse inverse(K, M, size);
  MassProduct mass(M, size);
  const auto wanted = static_cast<Eigen::Index>(count);
  const auto basis = std::min<Eigen::Index>(static_cast<Eigen::Index>(with_mass), 2 * wanted + 20);
  Spectra::SymGEigsShiftSolver<ShiftedInverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(inverse, mass,
                                                                                                    wanted, basis, 0.0);
  // Unknowns without mass must begin in balance with the others: one pass through M and K^-1 brings them there.
  Vector start = Vector::LinSpaced(size, 1.0, 2.0).array().sin();
  Vector product(size);
  mass.perform_op(start.data(), product.data());
  inverse.perform_op(product.data(), start.data());
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw ComputationError(fmt::format("the eigenvalue solver did not find {} modes; use more [span] elements", count));
  }
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < wanted; ++i) {
    const double omega2 = solver.eigenvalues()(i);
    if (omega2 < 0) {
      throw ComputationError(
          fmt::format("mode {} has a negative stiffness (omega^2 = {:.3g} 1/s^2): the state about "
                      "which it vibrates is unstable; raise the tension",
                      i + 1, omega2));
    }
    modes.push_back(scaled(omega2, solver.eigenvectors().col(i)));
  }
  return modes;
}

std::vector<Mode> transverse_modes(const System& system, const Vector& u, std::size_t count) {
  // Axial modes lie in between: ask for a few more until enough transverse ones are found.
  for (std::size_t asked = count + 4;; asked *= 2) {
    std::size_t with_mass = 0;
    for (std::size_t i = 0; i < system.unknowns(); ++i) with_mass += system.has_mass(i);
    asked = std::min(asked, with_mass - 1);
    std::vector<Mode> modes = lowest_modes(system, u, asked);
    std::erase_if(modes, [](const Mode& mode) { return !is_transverse(mode.shape); });
    if (modes.size() >= count) {
      modes.resize(count);
      return modes;
    }
    if (asked + 1 >= with_mass) {
      throw ComputationError(
          fmt::format("the mesh carries only {} modes across the span, mode {} was asked for; "
                      "give more [span] elements",
                      modes.size(), count));
    }
  }
}

}  // namespace strandyn::solver
