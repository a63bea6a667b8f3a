#pragma once
/// \file The motion of chosen nodes and the linear momentum of the chain, step by step.
///
///     P = sum over nodes of (M v), translations;   dP/dt = loads + supports - drag - springs to the ground
/// Internal forces add up to nothing, so the momentum is a check of elements and integrator that shares nothing with
/// the energy ledger. The impulse is the trapezoidal sum of the forces: exact where they change in straight lines.

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "strandyn/observe/step_record.hpp"

namespace strandyn::observe {

/// Displacements of some nodes from their places in the initial state.
class ProbeHistories final : public Observer {
 public:
  explicit ProbeHistories(std::vector<std::size_t> nodes) : nodes_(std::move(nodes)), histories_(nodes_.size()) {}

  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;

  std::size_t size() const { return nodes_.size(); }
  std::size_t node(std::size_t probe) const { return nodes_[probe]; }
  const std::vector<double>& times() const { return times_; }  ///< [s]
  /// [m] one entry per time.
  const std::vector<Eigen::Vector3d>& displacements(std::size_t probe) const { return histories_[probe]; }
  Eigen::Vector3d lowest(std::size_t probe) const;   ///< [m]
  Eigen::Vector3d highest(std::size_t probe) const;  ///< [m]
  /// [Hz] mean over whole cycles of the direction that moves most, from its passages upward through where it began.
  /// Empty with fewer than two of them.
  std::optional<double> frequency(std::size_t probe) const;

 private:
  void keep(const system::System& system, const StepRecord& record);

  std::vector<std::size_t> nodes_;
  std::vector<Eigen::Vector3d> start_;
  std::vector<double> times_;
  std::vector<std::vector<Eigen::Vector3d>> histories_;
};

/// Linear momentum against the impulse of all that acts from outside.
class MomentumObserver final : public Observer {
 public:
  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  bool wants_forces() const override { return true; }

  const Eigen::Vector3d& momentum() const { return momentum_; }  ///< [kg m/s]
  const Eigen::Vector3d& mass() const { return mass_; }          ///< [kg] that moves along each axis
  const Eigen::Vector3d& impulse() const { return impulse_; }    ///< [N s]
  double largest_deviation() const { return deviation_; }        ///< [N s] of the change of momentum from the impulse

 private:
  Eigen::Vector3d outer_force(const system::System& system, const StepRecord& record) const;
  Eigen::Vector3d find_momentum(const system::System& system, const StepRecord& record);

  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d momentum_ = start_, impulse_ = start_, force_ = start_;
  Eigen::Vector3d mass_ = start_;
  double deviation_ = 0;
  std::optional<system::Matrix> matrix_;
};

}  // namespace strandyn::observe
