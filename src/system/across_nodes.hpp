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
  std::vector<AcrossNode> nodes(model.nodes.size());
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    nodes[node] = {.node = node, .unknown = model.index(node, model::Unknown::y).value()};
  }
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    for (const std::size_t node : {e, e + 1}) nodes[node].length += model.elements[e].length / 2;
  }
  return nodes;
}

}  // namespace strandyn::system
