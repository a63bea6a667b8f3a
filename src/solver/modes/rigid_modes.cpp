#include "rigid_modes.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace strandyn::solver {

using model::Unknown;
using system::Matrix;
using system::System;
using system::Vector;

namespace {

constexpr Eigen::Index motions = 6;  // of a rigid body in space

Vector diagonal_of(const Matrix& A) {
  Vector diagonal(static_cast<Eigen::Index>(A.size()));
  math::with_block_size(A.block(), [&](auto B) {
    const auto& blocks = A.as<B()>();
    for (std::size_t node = 0; node < A.nodes(); ++node) {
      diagonal.segment<B()>(static_cast<Eigen::Index>(node) * B()) = blocks.diagonal(node).diagonal();
    }
  });
  return diagonal;
}

/// Columns: translations along the axes, rotations about them through the middle of the chain, these over its length.
Eigen::MatrixXd rigid_motions(const model::Model& model, const Vector& u) {
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(u.size(), motions);
  const Eigen::Vector3d middle = (model.nodes.front() + model.nodes.back()) / 2;
  const double length = model.unstressed_length();
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Vector3d at = model.nodes[node] + model.displacement(u.data(), node) - middle;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d turned = unit.cross(at) / length;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const auto place = model.index(node, static_cast<Unknown>(k));
        if (!place) continue;
        R(static_cast<Eigen::Index>(*place), axis) = unit(k);
        R(static_cast<Eigen::Index>(*place), 3 + axis) = turned(k);
      }
      const auto turn = model.index(node, static_cast<Unknown>(3 + axis));
      if (turn) R(static_cast<Eigen::Index>(*turn), 3 + axis) = 1 / length;
    }
  }
  return R;
}

/// Those combinations of the columns of R that are zero at held unknowns.
Eigen::MatrixXd unhindered(const System& system, const Eigen::MatrixXd& R) {
  std::vector<Eigen::Index> held;
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (system.is_held(i)) held.push_back(static_cast<Eigen::Index>(i));
  }
  if (held.empty()) return R;
  constexpr double nothing = 1e-9;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(R(held, Eigen::all), Eigen::ComputeFullV);
  const Vector& values = svd.singularValues();
  const auto hindered = (values.array() > nothing).count();
  return R * svd.matrixV().rightCols(motions - hindered);
}

/// Gram and Schmidt; drops what is nothing, such as a motion out of the plane of a planar chain.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& R, const Matrix& M) {
  Eigen::MatrixXd Q(R.rows(), 0);
  Vector product(R.rows());
  constexpr double nothing = 1e-10;
  double largest = 0;  // squared norm
  for (Eigen::Index k = 0; k < R.cols(); ++k) {
    Vector x = R.col(k);
    for (int pass = 0; pass < 2; ++pass) {
      M.multiply(x.data(), product.data());
      x -= Q * (Q.transpose() * product);
    }
    M.multiply(x.data(), product.data());
    const double square = x.dot(product);
    largest = std::max(largest, square);
    if (!(square > nothing * largest)) continue;
    Q.conservativeResize(Eigen::NoChange, Q.cols() + 1);
    Q.rightCols<1>() = x / std::sqrt(square);
  }
  return Q;
}

}  // namespace

std::vector<RawMode> find_rigid(const System& system, const Vector& u, const Matrix& K, const Matrix& M) {
  constexpr double rounding = 1e-12;  // of the stiffness that meets each unknown alone
  const Eigen::MatrixXd Q = orthonormal(unhindered(system, rigid_motions(system.model(), u)), M);
  if (Q.cols() == 0) return {};
  Eigen::MatrixXd forces(Q.rows(), Q.cols());
  for (Eigen::Index k = 0; k < Q.cols(); ++k) K.multiply(Q.col(k).data(), forces.col(k).data());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> stiffness(Q.transpose() * forces);
  const Vector diagonal = diagonal_of(K);
  std::vector<RawMode> modes;
  for (Eigen::Index k = 0; k < Q.cols(); ++k) {
    const Vector shape = Q * stiffness.eigenvectors().col(k);
    const double scale = shape.cwiseAbs2().dot(diagonal.cwiseAbs());
    if (std::abs(stiffness.eigenvalues()(k)) <= rounding * scale) modes.push_back({.eigenvalue = 0, .shape = shape});
  }
  return modes;
}

double shift_of_free_chain(const Matrix& K, const Matrix& M) {
  const Vector k = diagonal_of(K), m = diagonal_of(M);
  double largest = 0;
  for (Eigen::Index i = 0; i < k.size(); ++i) {
    if (m(i) > 0) largest = std::max(largest, k(i) / m(i));
  }
  return -1e-12 * largest;
}

}  // namespace strandyn::solver
