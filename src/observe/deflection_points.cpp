#include "strandyn/observe/deflection_points.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::observe {

namespace {

constexpr std::size_t places_per_element = 8;

std::array<double, 4> hermite(double xi, double length) {
  const double rest = 1 - xi;
  return {rest * rest * (1 + 2 * xi), length * xi * rest * rest, xi * xi * (3 - 2 * xi), -length * xi * xi * rest};
}

}  // namespace

DeflectionPoints::DeflectionPoints(const model::Model& model, double loop_length) {
  const std::vector<double> arc = model::arc_lengths(model);
  // A little less than three: the loop length of a tensioned beam is that of a string only nearly.
  const double margin = arc.back() >= 2.99 * loop_length ? loop_length : 0;
  planes_ = model::is_spatial(model.freedom) ? 2 : 1;
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double length = arc[e + 1] - arc[e];
    for (std::size_t place = 0; place < places_per_element; ++place) {
      const double xi = (static_cast<double>(place) + 0.5) / places_per_element;
      const double s = arc[e] + xi * length;
      if (s < margin || s > arc.back() - margin) continue;
      for (std::size_t plane = 0; plane < planes_; ++plane) add_point(model, {e, plane}, hermite(xi, length));
    }
  }
}

void DeflectionPoints::add_point(const model::Model& model, Place place, const std::array<double, 4>& weight) {
  using model::Unknown;
  const Eigen::Matrix3d& triad = model.elements[place.element].triad;
  const Eigen::Vector3d across = triad.col(static_cast<Eigen::Index>(place.plane + 1));
  // Turning about axis 3 lifts along axis 2; about axis 2 it lowers along axis 3.
  const Eigen::Vector3d axis = place.plane == 0 ? Eigen::Vector3d(triad.col(2)) : Eigen::Vector3d(-triad.col(1));
  for (std::size_t end = 0; end < 2; ++end) {
    const auto add = [&](Unknown first, const Eigen::Vector3d& part, double factor) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        const auto kind = static_cast<Unknown>(static_cast<Eigen::Index>(first) + i);
        const auto at = model.index(place.element + end, kind);
        if (at && part(i) != 0) terms_.push_back({.unknown = *at, .weight = factor * part(i)});
      }
    };
    add(Unknown::x, across, weight[2 * end]);
    add(Unknown::rotation_x, axis, weight[2 * end + 1]);
  }
  ends_.push_back(terms_.size());
}

double DeflectionPoints::at(const double* u, std::size_t i) const {
  double sum = 0;
  for (std::size_t t = i == 0 ? 0 : ends_[i - 1]; t < ends_[i]; ++t) sum += terms_[t].weight * u[terms_[t].unknown];
  return sum;
}

double DeflectionPoints::largest(const double* u) const {
  double largest = 0;
  for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, std::abs(at(u, i)));
  return largest;
}

}  // namespace strandyn::observe
