#include "strandyn/span/free_span.hpp"

#include <algorithm>

namespace strandyn::span {

using model::Unknown;

std::optional<Piece> between_inner_nodes(const std::vector<solver::LoopPoint>& points, double length,
                                         double loop_length) {
  constexpr double fewest_loops = 2.99;  // a loop of a tensioned beam is that of a string only nearly
  if (length < fewest_loops * loop_length) return std::nullopt;
  std::vector<double> nodes;
  for (const solver::LoopPoint& point : points) {
    const bool inner = point.position > loop_length / 2 && point.position < length - loop_length / 2;
    if (!point.antinode && inner) nodes.push_back(point.position);
  }
  if (nodes.size() < 2) return std::nullopt;
  return Piece{.from = nodes.front(), .to = nodes.back()};
}

std::optional<Piece> free_span_of(const SpanAtRest& span, const Eigen::VectorXcd& motion, double loop_length) {
  const model::Model& model = span.built.model;
  const auto swing = [&](Unknown across) {
    double squares = 0;
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      if (const auto at = model.index(node, across)) squares += std::norm(motion(static_cast<Eigen::Index>(*at)));
    }
    return squares;
  };
  const Unknown across = swing(Unknown::z) > swing(Unknown::y) ? Unknown::z : Unknown::y;
  return between_inner_nodes(solver::loop_points(model, across, motion), model::arc_lengths(model).back(), loop_length);
}

std::vector<double> section_lengths(const SpanAtRest& span, const Piece& piece) {
  const std::vector<double> arc = model::arc_lengths(span.built.model);
  std::vector<double> lengths(span.system.committed_strains().points());
  for (std::size_t p = 0; p < lengths.size(); ++p) {
    const std::size_t e = p / beam::gauss_points;
    const double part = (arc[e + 1] - arc[e]) / beam::gauss_points;
    const double begin = arc[e] + static_cast<double>(p % beam::gauss_points) * part;
    const double inside = std::min(begin + part, piece.to) - std::max(begin, piece.from);
    lengths[p] = span.system.point_length(p) * std::max(0.0, inside) / part;
  }
  return lengths;
}

double of_nodes(const model::Model& model, const std::vector<double>& by_node, const Piece& piece) {
  const std::vector<double> arc = model::arc_lengths(model);
  double sum = 0;
  for (std::size_t node = 0; node < by_node.size(); ++node) {
    const double left = node == 0 ? arc[0] : (arc[node - 1] + arc[node]) / 2;
    const double right = node + 1 == arc.size() ? arc[node] : (arc[node] + arc[node + 1]) / 2;
    const double inside = std::min(right, piece.to) - std::max(left, piece.from);
    sum += by_node[node] * std::max(0.0, inside) / (right - left);
  }
  return sum;
}

}  // namespace strandyn::span
