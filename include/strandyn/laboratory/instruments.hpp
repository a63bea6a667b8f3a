#pragma once
/// \file What the instruments of a test bench read: fundamentals, against a drive of phase 0 whose crest is at time 0.
///
///     x(t) = Re(X exp(i (w t + phase - pi/2))),   X = 2/T integral of x exp(-i (w t + phase - pi/2)) dt

#include <complex>
#include <vector>

#include "strandyn/laboratory/bench_span.hpp"
#include "strandyn/observe/cycles.hpp"

namespace strandyn::laboratory {

/// Of single points, cycle by cycle, by the trapezoidal rule: they may grow or decay.
class CyclePhasors final : public observe::Observer {
 public:
  CyclePhasors(const BenchSpan& bench, const Drive& drive) : bench_(bench), drive_(drive) {}
  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;

  const std::vector<std::complex<double>>& modal() const { return modal_; }    ///< [m] of the mode's coordinate
  const std::vector<std::complex<double>>& driven() const { return driven_; }  ///< [m] of the shaker's point
  const solver::InitialMotion& end() const { return end_; }                    ///< of the run

 private:
  struct Sample {
    std::complex<double> modal, driven;
  };
  Sample sample(const observe::StepRecord& record) const;

  const BenchSpan& bench_;
  Drive drive_;
  Sample before_, sum_;
  std::vector<std::complex<double>> modal_, driven_;
  solver::InitialMotion end_;
};

/// Of the whole span over all cycles of a steady run, each sample weighed with its step.
class SteadyPhasors final : public observe::Observer {
 public:
  /// `cycles` must listen before this: the forces of a step are those of its ledger.
  SteadyPhasors(const BenchSpan& bench, const Drive& drive, const observe::CycleObserver& cycles)
      : bench_(bench), drive_(drive), cycles_(cycles) {}
  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;
  bool wants_forces() const override { return true; }

  std::complex<double> force() const { return force_ / weight_; }    ///< [N] of the shaker
  std::complex<double> driven() const { return driven_ / weight_; }  ///< [m] its point
  Eigen::VectorXcd motion() const { return motion_ / weight_; }      ///< [m], [rad] of all unknowns
  /// Per section point, bending about both axes. [1/m], [N m]
  Eigen::MatrixXcd curvature() const { return curvature_ / weight_; }
  Eigen::MatrixXcd moment() const { return moment_ / weight_; }

 private:
  const BenchSpan& bench_;
  Drive drive_;
  const observe::CycleObserver& cycles_;
  double weight_ = 0;  // [s] half of the time
  std::complex<double> force_, driven_;
  Eigen::VectorXcd motion_;
  Eigen::MatrixXcd curvature_, moment_;  // a row per section point, a column per axis
};

}  // namespace strandyn::laboratory
