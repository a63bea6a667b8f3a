#include "strandyn/system/air_on_chain.hpp"

#include <cmath>
#include <numeric>

namespace strandyn::system {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using model::Unknown;

namespace {

constexpr Unknown translations[] = {Unknown::x, Unknown::y, Unknown::z};

}  // namespace

AirOnChain::AirOnChain(const model::Model& model)
    : model_(model), nodes_(model.nodes.size(), {.axis = Vector3d::Zero()}) {
  const std::vector<double> lengths = model::node_lengths(model);
  for (std::size_t node = 0; node < nodes_.size(); ++node) nodes_[node].length = lengths[node];
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const Vector3d chord = (model.nodes[e + 1] - model.nodes[e]).normalized();
    for (const std::size_t node : {e, e + 1}) nodes_[node].axis += chord;
  }
  for (Node& node : nodes_) node.axis.normalize();
}

Vector3d AirOnChain::across(std::size_t node, const double* v) const {
  const Vector3d velocity = model_.displacement(v, node);
  return velocity - velocity.dot(nodes_[node].axis) * nodes_[node].axis;
}

void AirOnChain::add_force(const air::AirForce& force, const double* v, double* f) const {
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const Vector3d w = across(node, v);
    const Vector3d on_node = nodes_[node].length * force.factor(w.norm()) * w;
    for (const Unknown unknown : translations) {
      if (const auto i = model_.index(node, unknown)) f[*i] += on_node(static_cast<Eigen::Index>(unknown));
    }
  }
}

void AirOnChain::add_tangent(const air::AirForce& force, const double* v, double factor, math::ChainMatrix& K) const {
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const Vector3d w = across(node, v);
    const double speed = w.norm();
    const Vector3d& axis = nodes_[node].axis;
    // d(|w|)/dw = w/|w|: nothing is left of it at rest.
    const double by_speed = speed > 0 ? force.quadratic / speed + 2 * force.cubic : 0;
    const Matrix3d slope =
        factor * nodes_[node].length *
        (force.factor(speed) * (Matrix3d::Identity() - axis * axis.transpose()) + by_speed * w * w.transpose());
    for (const Unknown row : translations) {
      for (const Unknown column : translations) {
        const auto i = model_.index(node, row);
        const auto j = model_.index(node, column);
        if (!i || !j) continue;
        K.add_at_node(*i, *j, slope(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
      }
    }
  }
}

std::vector<double> AirOnChain::power_by_node(const air::AirForce& force, const double* v) const {
  std::vector<double> power;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const Vector3d w = across(node, v);
    power.push_back(nodes_[node].length * force.factor(w.norm()) * w.squaredNorm());
  }
  return power;
}

std::vector<double> AirOnChain::swing_power_by_node(const air::AirForce& force, const Eigen::VectorXcd& v) const {
  const Eigen::VectorXd real = v.real(), imaginary = v.imag();
  std::vector<double> power;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const double square = across(node, real.data()).squaredNorm() + across(node, imaginary.data()).squaredNorm();
    power.push_back(nodes_[node].length * force.power_of_sine(std::sqrt(square)));
  }
  return power;
}

double AirOnChain::power(const air::AirForce& force, const double* v) const {
  const std::vector<double> power = power_by_node(force, v);
  return std::accumulate(power.begin(), power.end(), 0.0);
}

}  // namespace strandyn::system
