#include "strandyn/section/wire_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "return_map_kernel.hpp"
#include "spatial_return_map_kernel.hpp"

namespace strandyn::section {

namespace {

/// F_b at the midpoints: the integral of q less its mean, with zero mean over the two neutral points.
std::vector<double> bending_force(const std::vector<double>& q, double step, double neutral) {
  const std::size_t n = q.size();
  const double mean = std::accumulate(q.begin(), q.end(), 0.0) / static_cast<double>(n);
  std::vector<double> edge(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) edge[i + 1] = edge[i] + step * (q[i] - mean);
  const auto at = [&](double cells) {
    const std::size_t i = std::min(static_cast<std::size_t>(cells), n - 1);
    return std::lerp(edge[i], edge[i + 1], cells - static_cast<double>(i));
  };
  const double offset = (at(neutral) + at(neutral + static_cast<double>(n) / 2)) / 2;
  std::vector<double> middle(n);
  for (std::size_t i = 0; i < n; ++i) middle[i] = (edge[i] + edge[i + 1]) / 2 - offset;
  return middle;
}

/// [N/m^2] k_w = EA_w (sin(a)/R)^2, from what the march keeps of a wire.
double stiffness_against_slip(const PlanarCoefficients::Layer& layer, std::size_t points) {
  const double sine = layer.k / layer.force_per_strain;
  const double EA = layer.force_per_strain / (1 - sine * sine);
  const double turn = 2 * std::numbers::pi / static_cast<double>(points) / (2 * layer.half_step);
  return EA * turn * turn;
}

/// A layer from its gradients and what each angle sees of the curvature; `f_int_outside` enters as the load of the
/// layer outside and leaves as this one's own.
LayerState layer_state(const PlanarCoefficients::Layer& layer, std::vector<double> q, const std::vector<double>& e,
                       double axial_force, double neutral, double& f_int_outside) {
  LayerState s;
  const double k_w = stiffness_against_slip(layer, q.size());
  s.f_ext = layer.next_layer_ratio * f_int_outside;
  const double outer = layer.c_ext * s.f_ext;
  const std::vector<double> bending = bending_force(q, 2 * layer.half_step, neutral);
  s.mean_bending_force = std::accumulate(bending.begin(), bending.end(), 0.0) / static_cast<double>(q.size());
  s.mean_force = axial_force + s.mean_bending_force;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double force = axial_force + bending[i];
    const double inner = std::max(0.0, layer.kappa * force + outer + layer.inner_residual);
    const double limit = layer.mu_int * inner + layer.mu_ext * outer;
    s.force.push_back(force);
    s.limit.push_back(limit);
    s.slips.push_back(std::abs(q[i]) >= (1 - 1e-9) * limit);
    s.inner_load.push_back(inner * layer.inverse_c_int);
    s.slip.push_back((layer.k * e[i] - q[i]) / k_w);
  }
  s.gradient = std::move(q);
  s.f_int = layer.inverse_c_int * std::max(0.0, layer.kappa * s.mean_force + outer + layer.inner_residual);
  f_int_outside = s.f_int;
  return s;
}

std::vector<double> midpoints(std::size_t points) {
  std::vector<double> theta;
  for (std::size_t i = 0; i < points; ++i) {
    theta.push_back((static_cast<double>(i) + 0.5) * 2 * std::numbers::pi / static_cast<double>(points));
  }
  return theta;
}

/// [1/m] cos(theta) chi2 + sin(theta) chi3.
std::vector<double> seen_by_angles(const std::vector<double>& theta, double chi2, double chi3) {
  std::vector<double> e;
  for (const double angle : theta) e.push_back(std::cos(angle) * chi2 + std::sin(angle) * chi3);
  return e;
}

/// One number of one point in a block of the history.
struct PointRows {
  const double* at;
  double operator[](std::size_t row) const { return at[row * block_lanes]; }
};

PointRows rows_of(const History& history, std::size_t point, std::size_t rows_of_block) {
  return {history.data.data() + point / block_lanes * rows_of_block * block_lanes + point % block_lanes};
}

}  // namespace

/// With E the corners of the polygon, E' the next one, and q - mean(q) = |sin a|/R (E' - E)/(2 h):
///     mean[cos(theta) q] = |sin a|/R sin(h)/h mean[sin(theta_E) E] = |sin a|/R tan(h)/h mean[sin(theta) (E + E')/2]
double WireState::whole_force(const LayerState& layer, std::size_t angle) const {
  const double half = std::numbers::pi / static_cast<double>(theta.size());
  return layer.mean_force + std::tan(half) / half * (layer.force[angle] - layer.mean_force);
}

WireState SpatialReturnMap::wires(const History& history, const Field&, std::size_t point) const {
  using namespace spatial_kernel;
  const SpatialCoefficients& c = c_;
  const PointRows row = rows_of(history, point, rows_of_block(c));
  const double d2 = row[committed_chi2] - row[reference_chi2];
  const double d3 = row[committed_chi3] - row[reference_chi3];
  WireState state;
  state.theta = midpoints(static_cast<std::size_t>(c.points));
  const std::vector<double> e = seen_by_angles(state.theta, row[committed_chi2], row[committed_chi3]);
  double f_int = 0;
  for (std::size_t j = 0; j < c.layers.size(); ++j) {
    const SpatialCoefficients::Layer& layer = c.layers[j];
    const std::size_t first = scalar_rows + j * rows_of_layer(c) + layer_scalar_rows;
    std::vector<double> q;
    for (std::size_t i = 0; i < state.theta.size(); ++i) {
      q.push_back(row[first + i] + layer.k * (std::cos(state.theta[i]) * d2 + std::sin(state.theta[i]) * d3));
    }
    const double axial_force =
        layer.force_per_strain * row[committed_eps] + layer.force_per_twist * row[committed_twist];
    state.layers.push_back(layer_state(layer, std::move(q), e, axial_force, row[neutral], f_int));
    state.N_bending += layer.axial_weight * c.points * state.layers.back().mean_bending_force;
    state.M1_bending += layer.torsion_weight * c.points * state.layers.back().mean_bending_force;
  }
  std::reverse(state.layers.begin(), state.layers.end());
  return state;
}

/// The planar law commits no axial strain of its own. The second half of the turn mirrors the first.
WireState PlanarReturnMap::wires(const History& history, const Field& committed_strains, std::size_t point) const {
  const PlanarCoefficients& c = c_;
  const double eps = committed_strains[Component::axial][point];
  const PointRows row = rows_of(history, point, return_map_kernel::rows_of_block(c));
  const double d = row[return_map_kernel::committed_chi] - row[return_map_kernel::reference_chi];
  const std::size_t cells = c.cosine.size();
  WireState state;
  state.theta = midpoints(4 * cells);
  const std::vector<double> e = seen_by_angles(state.theta, row[return_map_kernel::committed_chi], 0);
  double f_int = 0;
  for (std::size_t j = 0; j < c.layers.size(); ++j) {
    const PlanarCoefficients::Layer& layer = c.layers[j];
    const std::size_t first = return_map_kernel::scalar_rows + j * 2 * cells;
    std::vector<double> q(4 * cells);
    for (std::size_t i = 0; i < cells; ++i) {
      const double stick = layer.k * c.cosine[i] * d;
      q[i] = row[first + i] + stick;                          // tension side, away from the neutral plane
      q[4 * cells - 1 - i] = row[first + cells + i] + stick;  // compression side
      q[2 * cells - 1 - i] = -q[i];                           // the mirror images across the plane of bending
      q[2 * cells + i] = -q[4 * cells - 1 - i];
    }
    state.layers.push_back(layer_state(layer, std::move(q), e, layer.force_per_strain * eps, 0, f_int));
    state.N_bending += layer.axial_weight * 4 * static_cast<double>(cells) * state.layers.back().mean_bending_force;
  }
  std::reverse(state.layers.begin(), state.layers.end());
  return state;
}

}  // namespace strandyn::section
