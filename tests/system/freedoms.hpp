#pragma once
/// \file Every kind of chain in one loop, for tests of what all of them share.

#include <doctest/doctest.h>

#include "system/spans.hpp"

namespace strandyn::test {

inline constexpr std::array every_freedom = {model::Freedom::planar, model::Freedom::spatial,
                                             model::Freedom::spatial_untwisted, model::Freedom::transverse_planar,
                                             model::Freedom::transverse_spatial};

/// Calls `check` with each freedom.
template <class F>
void for_every_freedom(F&& check) {
  for (const model::Freedom freedom : every_freedom) {
    CAPTURE(static_cast<int>(freedom));
    check(freedom);
  }
}

/// Index of an unknown that the chain has, for Eigen.
inline Eigen::Index place(const model::Model& model, std::size_t node, model::Unknown unknown) {
  return static_cast<Eigen::Index>(model.index(node, unknown).value());
}

/// A body of everything at a node, its spring and damper askew.
inline model::Body busy_body(std::size_t node) {
  return {.node = node,
          .mass = 3,
          .inertia = 0.02,
          .stiffness = 4e4,
          .damping = 70,
          .direction = Eigen::Vector3d(0.36, 0.8, 0.48)};
}

}  // namespace strandyn::test
