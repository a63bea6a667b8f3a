#include "strandyn/beam/spatial_lanes.hpp"

#include <algorithm>
#include <cstring>

#include "spatial_lanes_kernel.hpp"

namespace strandyn::beam {

using namespace spatial_lanes_kernel;

namespace {

/// Where an unknown of a node stands among the six.
std::size_t place_of(std::size_t unknown, std::size_t unknowns) {
  return unknowns == 5 && unknown > 2 ? unknown + 1 : unknown;
}

}  // namespace

SpatialLanes::SpatialLanes(const Chain& chain)
    : elements_(chain.elements.size()),
      stride_(lanes::stride_for(elements_)),
      unknowns_(static_cast<std::size_t>(chain.unknowns)),
      rows_(row_count * stride_, 0.0),
      none_(gauss_points * stride_, 0.0) {
  // What only fills a register is an element, too.
  for (const std::size_t one : {std::size_t{spatial_lanes_kernel::span}, std::size_t{length}, std::size_t{triad},
                                std::size_t{triad} + 4, std::size_t{triad} + 8}) {
    std::fill_n(row(one), stride_, 1.0);
  }
  for (std::size_t e = 0; e < elements_; ++e) {
    const SpatialElement& element = chain.elements[e];
    for (std::size_t i = 0; i < 3; ++i) row(spatial_lanes_kernel::span + i)[e] = element.span(static_cast<int>(i));
    row(length)[e] = element.length;
    row(excess)[e] = element.span.squaredNorm() - element.length * element.length;
    for (std::size_t i = 0; i < 9; ++i) row(triad + i)[e] = element.triad.data()[i];
    row(mass)[e] = chain.inertia.mass * element.length / 420;
    row(twist_inertia)[e] = chain.inertia.polar * element.length / 12;
  }
  for (std::size_t node = 0; node < chain.at_nodes.size(); ++node) {
    const Eigen::Matrix3d& J = chain.at_nodes[node].moment;
    const double entries[] = {J(0, 0), J(1, 0), J(2, 0), J(1, 1), J(2, 1), J(2, 2)};
    for (std::size_t i = 0; i < 6; ++i) row(moment + i)[node] = entries[i];
  }
}

/// Takes nodal numbers apart into six rows; false where they are those of last time.
bool SpatialLanes::take(std::size_t first_row, const double* nodal, std::vector<double>& last) {
  const std::size_t count = unknowns_ * (elements_ + 1);
  if (last.size() == count && std::memcmp(last.data(), nodal, count * sizeof(double)) == 0) return false;
  last.assign(nodal, nodal + count);
  for (std::size_t i = 0; i < unknowns_; ++i) {
    double* to = row(first_row + place_of(i, unknowns_));
    for (std::size_t node = 0; node <= elements_; ++node) to[node] = nodal[unknowns_ * node + i];
  }
  return true;
}

/// Turns of the nodes; what else is known of another position is known no more.
void SpatialLanes::see_position(const double* u) {
  if (!take(position, u, u_)) return;
  kinematics_known_ = spins_known_ = false;
  find_turns({rows_.data(), stride_, elements_});
}

void SpatialLanes::see_motion(const double* u, const double* v, const double* a) {
  see_position(u);
  const bool other_rates = take(rate, v, v_);
  const bool other_accelerations = take(acceleration, a, a_);
  if (spins_known_ && !other_rates && !other_accelerations) return;
  find_spins({rows_.data(), stride_, elements_});
  spins_known_ = true;
}

void SpatialLanes::find_strains(const double* u, const Strains& strains) {
  see_position(u);
  const Rows rows{rows_.data(), stride_, elements_};
  if (!kinematics_known_) find_kinematics(rows);
  kinematics_known_ = true;
  give_strains(rows, strains);
  // The last register reaches beyond the points, and what cannot twist has no twist.
  const std::size_t points = gauss_points * elements_;
  const std::size_t end = (elements_ + lanes::most_lanes - 1) / lanes::most_lanes * lanes::most_lanes * gauss_points;
  for (double* of : {strains.eps, strains.chi1, strains.chi2, strains.chi3}) std::fill(of + points, of + end, 0.0);
  if (unknowns_ == 5) std::fill(strains.chi1, strains.chi1 + points, 0.0);
}

SpatialLanes::Points SpatialLanes::without_twist(Points points) const {
  if (unknowns_ == 5) points.torsion = none_.data();
  return points;
}

void SpatialLanes::add_internal_force(const Points& resultants, double* f) {
  find_internal_force({rows_.data(), stride_, elements_}, without_twist(resultants));
  add_to_nodes(f);
}

void SpatialLanes::add_stiffness(const Points& resultants, const PointTangents& tangents, const Blocks& K) {
  PointTangents t;
  std::ranges::transform(tangents, t.begin(), [this](const Points& of) { return without_twist(of); });
  if (unknowns_ == 5) t[1] = {none_.data(), none_.data(), none_.data(), none_.data()};
  spatial_lanes_kernel::add_stiffness({rows_.data(), stride_, elements_}, without_twist(resultants), t, K);
}

void SpatialLanes::add_inertia_force(const double* u, const double* v, const double* a, double* f) {
  see_motion(u, v, a);
  find_inertia_force({rows_.data(), stride_, elements_});
  add_to_nodes(f);
}

void SpatialLanes::add_rotary_force(const double* u, const double* v, const double* a, double* f) {
  see_motion(u, v, a);
  find_rotary_torques({rows_.data(), stride_, elements_});
  for (std::size_t i = 3; i < unknowns_; ++i) {
    const double* torque = row(body_torque + place_of(i, unknowns_) - 3);
    for (std::size_t node = 0; node <= elements_; ++node) f[unknowns_ * node + i] += torque[node];
  }
}

void SpatialLanes::add_inertia_tangent(const double* u, const double* v, const double* a, const InertiaFactors& factors,
                                       const Blocks& K) {
  see_motion(u, v, a);
  find_spin_changes({rows_.data(), stride_, elements_}, factors);
  spatial_lanes_kernel::add_inertia_tangent({rows_.data(), stride_, elements_}, factors, K);
}

void SpatialLanes::add_rotary_tangent(const double* u, const double* v, const double* a, const InertiaFactors& factors,
                                      const Blocks& K) {
  see_motion(u, v, a);
  const Rows rows{rows_.data(), stride_, elements_};
  find_spin_changes(rows, factors);
  find_rotary_tangents(rows, factors);
  for (std::size_t c = 3; c < unknowns_; ++c) {
    for (std::size_t r = 3; r < unknowns_; ++r) {
      const double* entry = row(body_tangent + 3 * (place_of(c, unknowns_) - 3) + place_of(r, unknowns_) - 3);
      double* to = K.diagonal + unknowns_ * c + r;
      for (std::size_t node = 0; node <= elements_; ++node) to[unknowns_ * unknowns_ * node] += entry[node];
    }
  }
}

double SpatialLanes::kinetic_energy(const double* u, const double* v) {
  see_position(u);
  if (take(rate, v, v_)) spins_known_ = false;
  find_kinetic_energy({rows_.data(), stride_, elements_});
  double sum = 0;
  for (std::size_t e = 0; e < elements_; ++e) sum += at(energy, e);
  return sum;
}

void SpatialLanes::add_to_nodes(double* f) const {
  // One node of every element after the other: no sum waits for the one before.
  for (std::size_t node = 0; node < 2; ++node) {
    for (std::size_t i = 0; i < unknowns_; ++i) {
      const double* from = rows_.data() + (force_1 + 6 * node + place_of(i, unknowns_)) * stride_;
      double* to = f + unknowns_ * node + i;
      for (std::size_t e = 0; e < elements_; ++e) to[unknowns_ * e] += from[e];
    }
  }
}

}  // namespace strandyn::beam
