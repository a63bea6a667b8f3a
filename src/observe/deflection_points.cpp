#include "strandyn/observe/deflection_points.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::observe {

using model::unknowns_per_node;

namespace {

constexpr std::size_t places_per_element = 8;

std::array<double, 4> hermite(double xi, double length) {
  const double rest = 1 - xi;
  return {rest * rest * (1 + 2 * xi), length * xi * rest * rest, xi * xi * (3 - 2 * xi), -length * xi * xi * rest};
}

}  // namespace

DeflectionPoints::DeflectionPoints(const model::Model& model, double loop_length) {
  const double left = model.nodes.front().x();
  const double right = model.nodes.back().x();
  // A little less than three: the loop length of a tensioned beam is that of a string only nearly.
  const double margin = right - left >= 2.99 * loop_length ? loop_length : 0;
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double length = model.elements[e].span.x();
    for (std::size_t place = 0; place < places_per_element; ++place) {
      const double xi = (static_cast<double>(place) + 0.5) / places_per_element;
      const double x = model.nodes[e].x() + xi * length;
      if (x < left + margin || x > right - margin) continue;
      points_.push_back({.element = e, .weight = hermite(xi, length)});
    }
  }
}

double DeflectionPoints::at(const double* u, std::size_t i) const {
  const Point& p = points_[i];
  const double* node = u + p.element * unknowns_per_node;
  return p.weight[0] * node[1] + p.weight[1] * node[2] + p.weight[2] * node[4] + p.weight[3] * node[5];
}

double DeflectionPoints::largest(const double* u) const {
  double largest = 0;
  for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, std::abs(at(u, i)));
  return largest;
}

}  // namespace strandyn::observe
