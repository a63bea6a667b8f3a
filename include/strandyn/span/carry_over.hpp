#pragma once
/// \file A motion of a chain on another mesh of the same chain: where an iteration begins.

#include <Eigen/Dense>

#include "strandyn/model/model.hpp"

namespace strandyn::span {

/// `motion`: one row per unknown of `from`, any number of columns; the same with the unknowns of `to`. Both have the
/// same freedom. Between two nodes the deflections in the plane are cubics that keep the rotations, all else is linear:
/// right for straight chains to the order of their elements, near enough for others.
Eigen::MatrixXd carry_over(const model::Model& from, const Eigen::MatrixXd& motion, const model::Model& to);

}  // namespace strandyn::span
