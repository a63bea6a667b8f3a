#pragma once
/// \file The unknowns along y of a chain with the length of conductor that each node stands for: what wind acts on.

#include <vector>

#include "strandyn/model/model.hpp"

namespace strandyn::system {

struct AcrossNode {
  std::size_t node = 0;
  std::size_t unknown = 0;  ///< its place in the vectors
  double length = 0;        ///< [m]
};

inline std::vector<AcrossNode> across_nodes(const model::Model& model) {
  const std::vector<double> lengths = model::node_lengths(model);
  std::vector<AcrossNode> nodes;
  for (std::size_t node = 0; node < lengths.size(); ++node) {
    nodes.push_back({.node = node, .unknown = model.index(node, model::Unknown::y).value(), .length = lengths[node]});
  }
  return nodes;
}

}  // namespace strandyn::system
