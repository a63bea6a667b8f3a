#pragma once
/// \file Still air on the nodes of a chain. A node stands for half of the elements beside it, and only its velocity
/// across the axis of the reference configuration counts:
///     F = l (linear + quadratic |w| + cubic w^2) w,   w = v - (v . t) t
/// The force is against the velocity: it takes energy in every motion.

#include <Eigen/Dense>
#include <vector>

#include "strandyn/air/still_air.hpp"
#include "strandyn/math/chain_matrix.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::system {

class AirOnChain {
 public:
  /// `model` must outlive it.
  explicit AirOnChain(const model::Model& model);

  /// f += F at all nodes. [N]
  void add_force(const air::AirForce& force, const double* v, double* f) const;
  /// K += factor dF/dv. [N s/m]
  void add_tangent(const air::AirForce& force, const double* v, double factor, math::ChainMatrix& K) const;
  /// [W] v . F, never negative; of each node.
  std::vector<double> power_by_node(const air::AirForce& force, const double* v) const;
  double power(const air::AirForce& force, const double* v) const;
  /// [W] mean of each node where all swing at one frequency, with velocities Re(v exp(i omega t)) in one plane.
  std::vector<double> swing_power_by_node(const air::AirForce& force, const Eigen::VectorXcd& v) const;

 private:
  struct Node {
    double length = 0;     // [m] of conductor that it stands for
    Eigen::Vector3d axis;  // unit vector
  };
  Eigen::Vector3d across(std::size_t node, const double* v) const;

  const model::Model& model_;
  std::vector<Node> nodes_;
};

}  // namespace strandyn::system
