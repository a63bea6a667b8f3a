#pragma once
/// \file The fundamental of the whole motion, as a mean of the last cycles: where a vibration has its nodes.
///
///     X = 2/T integral of (u - u_0) exp(-i w t) dt     of each cycle, by the trapezoidal rule
/// A free vibration is not quite at the frequency that its cycles are counted by, so that its phase creeps: each cycle
/// is turned to the phase of the last before the mean is taken.

#include <deque>

#include "strandyn/observe/step_record.hpp"

namespace strandyn::observe {

struct FundamentalOptions {
  double period = 0;      ///< [s]
  std::size_t kept = 20;  ///< last cycles over which the mean is taken
};

/// A step over the end of a cycle is booked to the cycle that ends in it.
class Fundamental final : public Observer {
 public:
  explicit Fundamental(FundamentalOptions options) : options_(options) {}

  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  void archive(Archive& a) override;

  /// Phasors of all unknowns; empty before the first cycle has ended.
  Eigen::VectorXcd motion() const;

 private:
  Eigen::VectorXcd turned_back(const StepRecord& record) const;

  FundamentalOptions options_;
  std::size_t count_ = 0;  // of the cycles that have ended
  system::Vector rest_;
  Eigen::VectorXcd before_, sum_;
  double time_before_ = 0;
  std::deque<Eigen::VectorXcd> kept_;
};

}  // namespace strandyn::observe
