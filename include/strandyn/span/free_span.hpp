#pragma once
/// \file The free span of a vibration: what lies between its first and its last inner node, away from the supports.

#include <optional>
#include <vector>

#include "strandyn/solver/periodic/periodic.hpp"
#include "strandyn/span/rest.hpp"

namespace strandyn::span {

/// A piece of a span.
struct Piece {
  double from = 0, to = 0;  ///< [m] along the span
  double length() const { return to - from; }
};

/// Nothing where there are fewer than three loops, or fewer than two nodes. Inner nodes are half a loop and more away
/// from both ends. `loop_length` [m] half a wave.
std::optional<Piece> between_inner_nodes(const std::vector<solver::LoopPoint>& points, double length,
                                         double loop_length);
/// The same of a motion Re(x exp(i w t)) of all unknowns, in the direction in which it is larger.
std::optional<Piece> free_span_of(const SpanAtRest& span, const Eigen::VectorXcd& motion, double loop_length);

/// [m] of the length for which a section point stands, the part that lies in the piece: each stands for half of its
/// element. Loss per length times this, summed over all, is what the piece loses.
std::vector<double> section_lengths(const SpanAtRest& span, const Piece& piece);
/// What the nodes take that lie in the piece, each standing for half of the elements beside it.
double of_nodes(const model::Model& model, const std::vector<double>& by_node, const Piece& piece);

}  // namespace strandyn::span
