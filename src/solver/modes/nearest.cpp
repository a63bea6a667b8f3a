#include "nearest.hpp"

#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rigid_modes.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using system::Matrix;
using system::System;
using system::Vector;

namespace {

/// y = (K - sigma M)^-1 x, as Spectra wants it, without what lies along modes that are known already.
class ShiftedInverse {
 public:
  using Scalar = double;

  ShiftedInverse(const Matrix& K, const Matrix& M, const Stop& stop)
      : K_(K), M_(M), stop_(stop), size_(static_cast<Eigen::Index>(K.size())) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  void set_shift(double sigma) {
    Matrix shifted = K_;
    shifted.add(-sigma, M_);
    if (!factors_.factorize(shifted)) {
      throw ComputationError("the stiffness matrix is singular: the span is free to move; hold it by its supports");
    }
  }
  void perform_op(const double* x, double* y) const {
    end_if_asked(stop_);
    std::copy(x, x + size_, y);
    factors_.solve(y);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      Eigen::Map<Vector> v(y, size_);
      v -= known_[i] * momenta_[i].dot(v);
    }
  }
  void leave_out(const std::vector<RawMode>& modes) {
    for (const RawMode& mode : modes) {
      known_.push_back(mode.shape);
      momenta_.emplace_back(size_);
      M_.multiply(mode.shape.data(), momenta_.back().data());
    }
  }

 private:
  const Matrix& K_;
  const Matrix& M_;
  const Stop& stop_;
  Eigen::Index size_;
  math::ChainFactors factors_;
  std::vector<Vector> known_, momenta_;
};

/// y = M x.
class MassProduct {
 public:
  using Scalar = double;

  explicit MassProduct(const Matrix& M) : M_(M) {}
  Eigen::Index rows() const { return static_cast<Eigen::Index>(M_.size()); }
  Eigen::Index cols() const { return rows(); }
  void perform_op(const double* x, double* y) const { M_.multiply(x, y); }

 private:
  const Matrix& M_;
};

/// Held unknowns take no part in the motion: no mass, unit stiffness.
void take_out_held(const System& system, Matrix& K, Matrix& M) {
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (!system.is_held(i)) continue;
    K.pin(i, 1);
    M.pin(i, 0);
  }
}

/// What one run of the solver looks for.
struct Search {
  Eigen::Index wanted;
  Eigen::Index independent;  // unknowns with mass that are left
  double shift;              // [1/s^2]
};

std::vector<RawMode> nearest(ShiftedInverse& inverse, MassProduct& mass, const Search& search) {
  const Eigen::Index basis = std::min(search.independent, 2 * search.wanted + 20);
  Spectra::SymGEigsShiftSolver<ShiftedInverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, search.wanted, basis, search.shift);
  // Unknowns without mass must begin in balance with the others: one pass through M and K^-1 brings them there.
  Vector start = Vector::LinSpaced(inverse.rows(), 1.0, 2.0).array().sin();
  Vector product(start.size());
  mass.perform_op(start.data(), product.data());
  inverse.perform_op(product.data(), start.data());
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-12, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw ComputationError(
        fmt::format("the eigenvalue solver did not find {} modes; use more [span] elements", search.wanted));
  }
  const Vector values = solver.eigenvalues();
  const Eigen::MatrixXd shapes = solver.eigenvectors();  // made anew at every call
  std::vector<RawMode> modes;
  for (Eigen::Index i = 0; i < search.wanted; ++i) {
    modes.push_back({.eigenvalue = values(i), .shape = shapes.col(i)});
  }
  return modes;
}

/// [1/s] away from omega; an unstable mode counts as one of no frequency.
double distance(const RawMode& mode, double omega) {
  return std::abs(std::sqrt(std::max(0.0, mode.eigenvalue)) - omega);
}

void keep_nearest(std::vector<RawMode>& modes, std::size_t count, double omega) {
  std::stable_sort(modes.begin(), modes.end(),
                   [&](const RawMode& a, const RawMode& b) { return distance(a, omega) < distance(b, omega); });
  modes.resize(std::min(count, modes.size()));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const RawMode& a, const RawMode& b) { return a.eigenvalue < b.eigenvalue; });
}

}  // namespace

Pencil::Pencil(const System& system, const Vector& u) : K(system.make_matrix()), M(system.make_matrix()) {
  Vector force = system.make_vector();
  system.internal_force(u.data(), force.data(), K);
  system.subtract_external_tangent({.time = 0}, u.data(), K);
  system.mass_matrix(u.data(), M);
  K.make_symmetric();
  take_out_held(system, K, M);
}

std::size_t unknowns_with_mass(const System& system) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < system.unknowns(); ++i) n += system.has_mass(i);
  return n;
}

std::vector<RawMode> nearest_to(const System& system, const Pencil& pencil, const ModeOptions& options,
                                const std::vector<RawMode>& rigid) {
  const Matrix &K = pencil.K, &M = pencil.M;
  const double omega = 2 * std::numbers::pi * options.near;
  if (omega == 0 && options.count <= rigid.size()) return {rigid.begin(), rigid.begin() + options.count};
  const std::size_t count = omega == 0 ? options.count - rigid.size() : options.count;
  // A shift that meets an eigenvalue to many digits makes its mode drown all others.
  constexpr double aside = 1e-4;
  const bool free = omega == 0 && !rigid.empty();
  const double shift = free ? shift_of_free_chain(K, M) : std::pow(omega * (1 + aside), 2);
  const std::size_t with_mass = unknowns_with_mass(system) - (free ? rigid.size() : 0);
  const bool in_pairs = model::is_spatial(system.model().freedom);
  MassProduct mass(M);
  for (std::size_t asked = omega > 0 ? count + 2 : count;; asked += asked / 2 + 2) {
    asked = std::min(asked, with_mass - 1);
    ShiftedInverse inverse(K, M, options.stop);
    if (free) inverse.leave_out(rigid);
    const Search search{.wanted = static_cast<Eigen::Index>(asked),
                        .independent = static_cast<Eigen::Index>(with_mass),
                        .shift = shift};
    std::vector<RawMode> raw = nearest(inverse, mass, search);
    double reach = 0;  // in the square: what is nearer has been found
    for (const RawMode& mode : raw) reach = std::max(reach, std::abs(mode.eigenvalue - shift));
    if (in_pairs && 2 * asked < with_mass) {
      // One Krylov space need not hold both of two modes of equal frequency: look once more beside what was found.
      inverse.leave_out(raw);
      Search again = search;
      again.independent -= search.wanted;
      for (RawMode& mode : nearest(inverse, mass, again)) raw.push_back(std::move(mode));
      keep_nearest(raw, asked + 1, omega);  // one more, lest a pair is cut in two
      separate_planes(system.model(), M, raw);
    }
    keep_nearest(raw, count, omega);
    if (free) raw.insert(raw.begin(), rigid.begin(), rigid.end());
    double farthest = 0;
    for (const RawMode& mode : raw) farthest = std::max(farthest, distance(mode, omega));
    if (omega == 0 || asked + 1 >= with_mass || std::pow(omega + farthest, 2) - shift <= reach) return raw;
  }
}

bool are_apart(const RawMode& lower, const RawMode& upper) {
  constexpr double relative = 1e-6;
  return upper.eigenvalue - lower.eigenvalue > relative * std::abs(upper.eigenvalue);
}

std::size_t modes_below(const Pencil& pencil, const RawMode& mode) {
  constexpr double below = 1e-7;  // relative
  Matrix shifted = pencil.K;
  shifted.add(-mode.eigenvalue * (1 - below), pencil.M);
  return math::negative_eigenvalues(shifted);
}

std::size_t modes_below(const Pencil& pencil, const std::vector<RawMode>& modes) {
  for (std::size_t i = 1; i < modes.size(); ++i) {
    if (are_apart(modes[i - 1], modes[i])) return modes_below(pencil, modes[i]) - i;
  }
  return modes_below(pencil, modes.front());
}

}  // namespace strandyn::solver
