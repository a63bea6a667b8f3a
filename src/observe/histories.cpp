#include "strandyn/observe/histories.hpp"

#include <algorithm>

namespace strandyn::observe {

using Eigen::Vector3d;
using system::Vector;

namespace {

/// Sum over the nodes of the three components of a force or momentum.
Vector3d total(const model::Model& model, const Vector& vector) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t node = 0; node < model.nodes.size(); ++node) sum += model.displacement(vector.data(), node);
  return sum;
}

/// What drag, air and dampers take from the momentum. [N]
Vector3d viscous_force(const system::System& system, const Vector& v) {
  const model::Model& model = system.model();
  Vector3d sum = Vector3d::Zero();
  if (!system.air().is_none()) {
    Vector force = system.make_vector();
    system.air_on_chain().add_force(system.air(), v.data(), force.data());
    sum += total(model, force);
  }
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double share = model.drag * model.elements[e].length / 2;
    for (std::size_t node : {e, e + 1}) sum += share * model.displacement(v.data(), node);
  }
  for (const model::Body& body : model.bodies) {
    sum += body.damping * body.direction.dot(model.displacement(v.data(), body.node)) * body.direction;
  }
  return sum;
}

}  // namespace

void ProbeHistories::begin(const system::System& system, const StepRecord& initial) {
  for (std::size_t node : nodes_) start_.push_back(system.model().displacement(initial.u.data(), node));
  keep(system, initial);
}

void ProbeHistories::step(const system::System& system, const StepRecord& record) {
  keep(system, record);
}

void ProbeHistories::keep(const system::System& system, const StepRecord& record) {
  times_.push_back(record.time);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    histories_[i].push_back(system.model().displacement(record.u.data(), nodes_[i]) - start_[i]);
  }
}

Vector3d ProbeHistories::lowest(std::size_t probe) const {
  Vector3d low = Vector3d::Zero();
  for (const Vector3d& d : histories_[probe]) low = low.cwiseMin(d);
  return low;
}

Vector3d ProbeHistories::highest(std::size_t probe) const {
  Vector3d high = Vector3d::Zero();
  for (const Vector3d& d : histories_[probe]) high = high.cwiseMax(d);
  return high;
}

std::optional<double> ProbeHistories::frequency(std::size_t probe) const {
  Eigen::Index axis = 0;
  (highest(probe) - lowest(probe)).maxCoeff(&axis);
  const std::vector<Vector3d>& d = histories_[probe];
  // Ripples about the start are no cycles: between two passages the motion must have gone well below it.
  const double below = lowest(probe)(axis) / 20;
  bool has_been_below = false;
  std::vector<double> passages;
  for (std::size_t i = 1; i < d.size(); ++i) {
    const double before = d[i - 1](axis);
    const double after = d[i](axis);
    has_been_below = has_been_below || before < below;
    if (!has_been_below || before >= 0 || after < 0) continue;
    passages.push_back(times_[i - 1] + (times_[i] - times_[i - 1]) * before / (before - after));
    has_been_below = false;
  }
  if (passages.size() < 2) return std::nullopt;
  return static_cast<double>(passages.size() - 1) / (passages.back() - passages.front());
}

Vector3d MomentumObserver::outer_force(const system::System& system, const StepRecord& record) const {
  const model::Model& model = system.model();
  if (record.external.size() != record.u.size()) throw ComputationError("momentum needs the forces of every step");
  Vector external = record.external;
  Vector resistance = record.internal;
  const system::State state{.u = record.u.data(), .v = record.v.data(), .a = record.a.data()};
  system.add_inertia_and_drag(state, resistance.data());
  Vector attached = system.make_vector();
  system.add_attached_force(state, record.time, attached.data());
  resistance += attached;
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (system.is_held(i)) external(static_cast<Eigen::Index>(i)) = resistance(static_cast<Eigen::Index>(i));
  }
  // Of the internal forces only those of springs to the ground are left in the sum.
  return total(model, external) - total(model, record.internal) - total(model, attached) -
         viscous_force(system, record.v);
}

Vector3d MomentumObserver::find_momentum(const system::System& system, const StepRecord& record) {
  system.mass_matrix(record.u.data(), *matrix_);
  Vector product = system.make_vector();
  matrix_->multiply(record.v.data(), product.data());
  return total(system.model(), product);
}

void MomentumObserver::begin(const system::System& system, const StepRecord& initial) {
  const model::Model& model = system.model();
  matrix_.emplace(system.make_matrix());
  start_ = momentum_ = find_momentum(system, initial);
  force_ = outer_force(system, initial);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Vector along = system.make_vector();
    Vector product = along;
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      if (const auto i = model.index(node, static_cast<model::Unknown>(axis))) along(static_cast<Eigen::Index>(*i)) = 1;
    }
    matrix_->multiply(along.data(), product.data());
    mass_(axis) = along.dot(product);
  }
}

void MomentumObserver::step(const system::System& system, const StepRecord& record) {
  const Vector3d force = outer_force(system, record);
  impulse_ += 0.5 * record.step * (force_ + force);
  force_ = force;
  momentum_ = find_momentum(system, record);
  deviation_ = std::max(deviation_, (momentum_ - start_ - impulse_).norm());
}

}  // namespace strandyn::observe
