#pragma once
/// \file Where deflections are read: several places in every element away from the ends of a span, so that an antinode
/// between two nodes is not missed.
///
///     y(xi) = H1 y_1 + H2 l theta_1 + H3 y_2 + H4 l theta_2        Hermite, small rotations from the reference line
/// Eight places an element miss a crest by at most pi^2/2 (l/16)^2/loop^2: 0.1 % with five elements a loop.

#include <array>
#include <cstddef>
#include <vector>

#include "strandyn/model/model.hpp"

namespace strandyn::observe {

class DeflectionPoints {
 public:
  /// Places at least `loop_length` [m] from both ends; all of the span where it has fewer than three loops.
  DeflectionPoints(const model::Model& model, double loop_length);

  std::size_t size() const { return ends_.size(); }
  std::size_t planes() const { return planes_; }
  /// [m] deflection across the reference line at place i; `u` holds all unknowns. A spatial chain has two directions
  /// across at each place, one after the other.
  double at(const double* u, std::size_t i) const;
  /// Largest deflection in size: the antinode of a mode shape.
  double largest(const double* u) const;

 private:
  struct Place {
    std::size_t element = 0;
    std::size_t plane = 0;  // 0: along the sections' axis 2, 1: along axis 3
  };
  struct Term {
    std::size_t unknown = 0;
    double weight = 0;
  };
  void add_point(const model::Model& model, Place place, const std::array<double, 4>& weight);

  std::size_t planes_ = 1;
  std::vector<Term> terms_;        // of all places, one after the other
  std::vector<std::size_t> ends_;  // where the terms of each place end
};

}  // namespace strandyn::observe
