#include "strandyn/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::model {
namespace {

/// Section axes of a first element: 2 across and upward as far as it goes, 3 to the right-hand side of both.
Eigen::Matrix3d first_triad(const Eigen::Vector3d& along) {
  const bool upright = std::abs(along.y()) > 0.999 * along.norm();
  const Eigen::Vector3d up = upright ? Eigen::Vector3d(-along.y(), 0, 0) : Eigen::Vector3d(0, 1, 0);
  Eigen::Matrix3d triad;
  triad.col(0) = along.normalized();
  triad.col(2) = triad.col(0).cross(up).normalized();
  triad.col(1) = triad.col(2).cross(triad.col(0));
  return triad;
}

/// The triad of the element before, turned by the shortest way onto the new direction: no twist at a corner.
Eigen::Matrix3d next_triad(const Eigen::Matrix3d& before, const Eigen::Vector3d& along) {
  const Eigen::Vector3d direction = along.normalized();
  return Eigen::Quaterniond::FromTwoVectors(before.col(0), direction).toRotationMatrix() * before;
}

/// Elements between the nodes, their unstressed length the reference one over 1 + strain.
void join_nodes(Model& model, double strain, const std::vector<double>& strains = {}) {
  model.elements.clear();
  for (std::size_t i = 0; i + 1 < model.nodes.size(); ++i) {
    const Eigen::Vector3d d = model.nodes[i + 1] - model.nodes[i];
    const Eigen::Matrix3d triad = i == 0 ? first_triad(d) : next_triad(model.elements.back().triad, d);
    model.elements.push_back(
        {.span = d, .length = d.norm() / (1 + (strains.empty() ? strain : strains[i])), .triad = triad});
  }
}

}  // namespace

std::optional<std::size_t> Model::index(std::size_t node, Unknown unknown) const {
  const auto place = place_of(freedom, unknown);
  if (!place) return std::nullopt;
  return node * unknowns_per_node() + *place;
}

std::string Model::unknown_name(std::size_t index) const {
  return fmt::format("node {} {}", index / unknowns_per_node(), name_of(kind(index)));
}

double Model::unstressed_length() const {
  double sum = 0;
  for (const beam::SpatialElement& element : elements) sum += element.length;
  return sum;
}

Eigen::Vector3d Model::displacement(const double* u, std::size_t node) const {
  Eigen::Vector3d d = Eigen::Vector3d::Zero();
  for (Unknown unknown : {Unknown::x, Unknown::y, Unknown::z}) {
    if (const auto i = index(node, unknown)) d(static_cast<Eigen::Index>(unknown)) = u[*i];
  }
  return d;
}

Eigen::Vector3d Model::rotation(const double* u, std::size_t node) const {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  for (Unknown unknown : {Unknown::rotation_x, Unknown::rotation_y, Unknown::rotation_z}) {
    if (const auto i = index(node, unknown)) r(static_cast<Eigen::Index>(unknown) - 3) = u[*i];
  }
  return r;
}

void lay_out(Model& model, const StraightSpan& span) {
  model.nodes.clear();
  for (double s : span.positions) model.nodes.push_back(span.start + s * span.direction);
  join_nodes(model, span.strain, span.strains);
}

void lay_out(Model& model, const Polyline& line) {
  model.nodes.clear();
  double start = 0;  // of the piece
  std::size_t piece = 0;
  for (double s : line.positions) {
    const auto length = [&] { return (line.corners[piece + 1] - line.corners[piece]).norm(); };
    while (piece + 2 < line.corners.size() && s > start + length() * (1 + 1e-12)) {
      start += length();
      ++piece;
    }
    const double part = (s - start) / length();
    model.nodes.push_back(line.corners[piece] + part * (line.corners[piece + 1] - line.corners[piece]));
  }
  join_nodes(model, 0);
}

std::vector<double> arc_lengths(const Model& model) {
  std::vector<double> s = {0};
  for (const beam::SpatialElement& element : model.elements) s.push_back(s.back() + element.span.norm());
  return s;
}

std::vector<double> node_lengths(const Model& model) {
  std::vector<double> lengths(model.nodes.size(), 0.0);
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    for (const std::size_t node : {e, e + 1}) lengths[node] += model.elements[e].length / 2;
  }
  return lengths;
}

std::size_t nearest_node(const Model& model, double position) {
  const std::vector<double> s = arc_lengths(model);
  const auto nearest = std::min_element(
      s.begin(), s.end(), [&](double a, double b) { return std::abs(a - position) < std::abs(b - position); });
  return static_cast<std::size_t>(nearest - s.begin());
}

}  // namespace strandyn::model
