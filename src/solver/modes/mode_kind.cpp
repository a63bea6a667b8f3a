#include "mode_kind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::solver {

using model::Unknown;
using system::Matrix;
using system::Vector;

namespace {

Vector times(const Matrix& M, const Vector& x) {
  Vector y(x.size());
  M.multiply(x.data(), y.data());
  return y;
}

/// phi_a^T M phi_b split by kind of motion: translations by the axes of the reference chain, rotations as twist or, for
/// those of bending, with the plane they bend in.
std::array<double, 4> energy_shares(const model::Model& model, const Vector& shape, const Vector& momentum) {
  std::array<double, 4> share{};
  const auto add = [&](ModeKind kind, double value) { share[static_cast<std::size_t>(kind)] += value; };
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Matrix3d& triad = model.elements[std::min(node, model.elements.size() - 1)].triad;
    const Eigen::Vector3d d = triad.transpose() * model.displacement(shape.data(), node);
    const Eigen::Vector3d p = triad.transpose() * model.displacement(momentum.data(), node);
    add(ModeKind::axial, d.x() * p.x());
    add(ModeKind::in_plane, d.y() * p.y());
    add(ModeKind::out_of_plane, d.z() * p.z());
    const auto product = [&](Unknown unknown) {
      const auto i = model.index(node, unknown);
      return i ? shape(static_cast<Eigen::Index>(*i)) * momentum(static_cast<Eigen::Index>(*i)) : 0.0;
    };
    add(ModeKind::torsional, product(Unknown::rotation_x));
    add(ModeKind::out_of_plane, product(Unknown::rotation_y));
    add(ModeKind::in_plane, product(Unknown::rotation_z));
  }
  return share;
}

}  // namespace

const char* name_of(ModeKind kind) {
  constexpr std::array names = {"axial", "in-plane", "out-of-plane", "torsional", "rigid"};
  return names[static_cast<std::size_t>(kind)];
}

void separate_planes(const model::Model& model, const Matrix& M, std::vector<RawMode>& modes) {
  constexpr double equal = 1e-6;  // relative
  for (std::size_t first = 0; first < modes.size();) {
    std::size_t end = first + 1;
    while (end < modes.size() &&
           modes[end].eigenvalue - modes[first].eigenvalue <= equal * std::abs(modes[end].eigenvalue)) {
      ++end;
    }
    const auto n = static_cast<Eigen::Index>(end - first);
    if (n > 1) {
      // The share of in-plane energy is a quadratic form: its principal axes are what is wanted.
      Eigen::MatrixXd in_plane(n, n);
      for (Eigen::Index a = 0; a < n; ++a) {
        for (Eigen::Index b = 0; b < n; ++b) {
          const auto shares = energy_shares(model, modes[first + static_cast<std::size_t>(a)].shape,
                                            times(M, modes[first + static_cast<std::size_t>(b)].shape));
          in_plane(a, b) = shares[static_cast<std::size_t>(ModeKind::in_plane)];
        }
      }
      in_plane = (0.5 * (in_plane + in_plane.transpose())).eval();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(in_plane);
      std::vector<Vector> turned;
      for (Eigen::Index k = n; k-- > 0;) {  // in-plane first
        Vector shape = Vector::Zero(modes[first].shape.size());
        for (Eigen::Index a = 0; a < n; ++a) {
          shape += axes.eigenvectors()(a, k) * modes[first + static_cast<std::size_t>(a)].shape;
        }
        turned.push_back(std::move(shape));
      }
      for (std::size_t k = 0; k < turned.size(); ++k) modes[first + k].shape = turned[k];
    }
    first = end;
  }
}

Mode describe(const model::Model& model, const Matrix& M, const RawMode& raw) {
  const auto shares = energy_shares(model, raw.shape, times(M, raw.shape));
  const auto kind = static_cast<ModeKind>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  double largest = 0;
  for (Eigen::Index i = 0; i < raw.shape.size(); ++i) {
    const bool rotation = model::is_rotation(model.kind(static_cast<std::size_t>(i)));
    if (rotation != (kind == ModeKind::torsional)) continue;
    if (std::abs(raw.shape(i)) > std::abs(largest)) largest = raw.shape(i);
  }
  return {.frequency = std::sqrt(std::max(raw.eigenvalue, 0.0)) / (2 * std::numbers::pi),
          .kind = kind,
          .shape = raw.shape / largest,
          .modal_mass = 1 / (largest * largest)};
}

}  // namespace strandyn::solver
