#include "strandyn/beam/planar_lanes.hpp"

#include <algorithm>

#include "planar_lanes_kernel.hpp"

namespace strandyn::beam {

using namespace planar_lanes_kernel;

namespace {

constexpr std::size_t unknowns = 3;  // of a node

}  // namespace

PlanarLanes::PlanarLanes(std::span<const PlanarElement> elements, double mass_per_length)
    : elements_(elements.size()),
      stride_(lanes::stride_for(elements.size())),
      rows_(row_count * stride_, 0.0),
      stiffness_(stiffness_entries * stride_, 0.0),
      inertia_(inertia_entries * stride_, 0.0) {
  // What only fills a register has a length.
  std::fill_n(row(span_x), stride_, 1.0);
  std::fill_n(row(length), stride_, 1.0);
  std::fill_n(row(chord), stride_, 1.0);
  for (std::size_t e = 0; e < elements_; ++e) {
    const PlanarElement& element = elements[e];
    row(span_x)[e] = element.span.x();
    row(span_y)[e] = element.span.y();
    row(length)[e] = element.length;
    row(rest_angle)[e] = element.rest_angle;
    row(excess)[e] = element.span.squaredNorm() - element.length * element.length;
    row(mass)[e] = mass_per_length * element.length / 420;
  }
}

void PlanarLanes::take(std::size_t first_row, const double* nodal) {
  double* along = row(first_row);
  double* across = row(first_row + 1);
  double* turning = row(first_row + 2);
  for (std::size_t node = 0; node <= elements_; ++node) {
    along[node] = nodal[unknowns * node];
    across[node] = nodal[unknowns * node + 1];
    turning[node] = nodal[unknowns * node + 2];
  }
}

void PlanarLanes::find_strains(const double* u, double* eps, double* chi) {
  take(x, u);
  find_kinematics({rows_.data(), stride_, elements_}, eps, chi);
  // The last register reaches beyond the points.
  const std::size_t points = gauss_points * elements_;
  const std::size_t end = (elements_ + most_lanes - 1) / most_lanes * most_lanes * gauss_points;
  std::fill(eps + points, eps + end, 0.0);
  std::fill(chi + points, chi + end, 0.0);
}

void PlanarLanes::add_internal_force(const double* N, const double* M, double* f) {
  find_internal_force({rows_.data(), stride_, elements_}, N, M);
  add_to_nodes(force_x_1, f);
}

PlanarKinematics PlanarLanes::kinematics(std::size_t e) const {
  PlanarKinematics k;
  k.eps = at(strain, e);
  k.chi = {at(curvature_1, e), at(curvature_2, e)};
  k.chord = at(chord, e);
  k.direction = {at(along_x, e), at(along_y, e)};
  k.rotation = {at(rotation_1, e), at(rotation_2, e)};
  return k;
}

void PlanarLanes::find_tangents(const double* N, const double* M, const PointTangents& t) {
  find_stiffness({rows_.data(), stride_, elements_}, N, M, {t.N_eps, t.N_chi, t.M_eps, t.M_chi}, stiffness_.data());
}

PlanarMatrix PlanarLanes::tangent(std::size_t e) const {
  const double* tile = stiffness_.data() + place_in_tile(e, 0, stiffness_entries);
  const auto k = [tile](std::size_t entry) { return tile[entry * most_lanes]; };
  PlanarMatrix K;
  for (int i = 0; i < 2; ++i) {
    const double row_sign = i == 0 ? -1 : 1;
    const auto row = static_cast<std::size_t>(2 * i);
    for (int j = 0; j < 2; ++j) {
      const double column_sign = j == 0 ? -1 : 1;
      const auto column = static_cast<std::size_t>(2 * j);
      const double sign = row_sign * column_sign;
      K(3 * i, 3 * j) = sign * k(ends_xx);
      K(3 * i, 3 * j + 1) = sign * k(ends_xy);
      K(3 * i + 1, 3 * j) = sign * k(ends_yx);
      K(3 * i + 1, 3 * j + 1) = sign * k(ends_yy);
      K(3 * i, 3 * j + 2) = row_sign * k(by_turn_x_1 + column);
      K(3 * i + 1, 3 * j + 2) = row_sign * k(by_turn_y_1 + column);
      K(3 * i + 2, 3 * j) = column_sign * k(of_turn_x_1 + row);
      K(3 * i + 2, 3 * j + 1) = column_sign * k(of_turn_y_1 + row);
      K(3 * i + 2, 3 * j + 2) = k(turns_11 + row + static_cast<std::size_t>(j));
    }
  }
  return K;
}

void PlanarLanes::find_directions(const double* u) {
  double* turns = row(turned);
  bool same = directions_known_;
  for (std::size_t node = 0; same && node <= elements_; ++node) same = turns[node] == u[unknowns * node + 2];
  if (same) return;
  for (std::size_t node = 0; node <= elements_; ++node) turns[node] = u[unknowns * node + 2];
  planar_lanes_kernel::find_directions({rows_.data(), stride_, elements_});
  directions_known_ = true;
}

void PlanarLanes::add_inertia_force(const double* u, const double* v, const double* a, double* f) {
  find_directions(u);
  take(rate_x, v);
  take(acceleration_x, a);
  find_inertia_force({rows_.data(), stride_, elements_});
  add_to_nodes(force_x_1, f);
}

void PlanarLanes::find_inertia_tangents(const double* u, const double* v, const double* a,
                                        const InertiaFactors& factors) {
  find_directions(u);
  take(rate_x, v);
  take(acceleration_x, a);
  find_inertia_tangent({rows_.data(), stride_, elements_}, factors, inertia_.data());
}

PlanarMatrix PlanarLanes::inertia_tangent(std::size_t e) const {
  const double* tile = inertia_.data() + place_in_tile(e, 0, inertia_entries);
  const auto k = [tile](std::size_t entry) { return tile[entry * most_lanes]; };
  PlanarMatrix K;
  for (int i = 0; i < 2; ++i) {
    const auto row = static_cast<std::size_t>(4 * i);
    for (int j = 0; j < 2; ++j) {
      const auto column = static_cast<std::size_t>(2 * j);
      const double mass = k(i == j ? near_node : far_node);
      K(3 * i, 3 * j) = K(3 * i + 1, 3 * j + 1) = mass;
      K(3 * i, 3 * j + 1) = K(3 * i + 1, 3 * j) = 0;
      K(3 * i, 3 * j + 2) = k(node_1_by_turn_x_1 + row + column);
      K(3 * i + 1, 3 * j + 2) = k(node_1_by_turn_y_1 + row + column);
      K(3 * i + 2, 3 * j) = k(turn_1_by_node_x_1 + row + column);
      K(3 * i + 2, 3 * j + 1) = k(turn_1_by_node_y_1 + row + column);
      K(3 * i + 2, 3 * j + 2) = k(inertia_turns_11 + row / 2 + static_cast<std::size_t>(j));
    }
  }
  return K;
}

double PlanarLanes::kinetic_energy(const double* u, const double* v) {
  find_directions(u);
  take(rate_x, v);
  find_kinetic_energy({rows_.data(), stride_, elements_});
  double sum = 0;
  for (std::size_t e = 0; e < elements_; ++e) sum += at(energy, e);
  return sum;
}

void PlanarLanes::add_to_nodes(std::size_t first_row, double* f) const {
  // One node of every element after the other: no sum waits for the one before.
  for (std::size_t node = 0; node < 2; ++node) {
    double* to = f + unknowns * node;
    const double* rows = rows_.data() + (first_row + unknowns * node) * stride_;
    for (std::size_t e = 0; e < elements_; ++e) {
      for (std::size_t i = 0; i < unknowns; ++i) to[unknowns * e + i] += rows[i * stride_ + e];
    }
  }
}

}  // namespace strandyn::beam
