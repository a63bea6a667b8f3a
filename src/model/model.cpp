#include "strandyn/model/model.hpp"

#include <fmt/format.h>

#include <cmath>

namespace strandyn::model {

double Model::unstressed_length() const {
  double sum = 0;
  for (const beam::PlanarElement& element : elements) sum += element.length;
  return sum;
}

std::string unknown_name(std::size_t index) {
  constexpr std::array<const char*, unknowns_per_node> names = {"displacement x", "displacement y", "rotation"};
  return fmt::format("node {} {}", index / unknowns_per_node, names[index % unknowns_per_node]);
}

void lay_out(Model& model, const StraightSpan& span) {
  model.nodes.clear();
  model.elements.clear();
  for (double x : span.positions) model.nodes.emplace_back(x, 0.0);
  for (std::size_t i = 0; i + 1 < model.nodes.size(); ++i) {
    const Eigen::Vector2d d = model.nodes[i + 1] - model.nodes[i];
    model.elements.push_back({.span = d, .length = d.norm() / (1 + span.strain), .rest_angle = 0});
  }
}

std::size_t nearest_node(const Model& model, double position) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < model.nodes.size(); ++i) {
    if (std::abs(model.nodes[i].x() - position) < std::abs(model.nodes[best].x() - position)) best = i;
  }
  return best;
}

}  // namespace strandyn::model
