#pragma once
/// \file A test bench in time: the span is brought to resonance at the wanted amplitude, measured in steady state, and
/// let go.
///
/// settle:  runs of a few cycles, each at one drive; after each the control says the next drive. Once amplitude and
///          phase are right the drive is held.
/// steady:  20 cycles at a held drive, all of like amplitude, in which what comes in is what is lost.
/// measure: N cycles more.
/// decay:   the shaker is let go: no force, or its point held where it was at rest.

#include "bench_control.hpp"
#include "bench_recorder.hpp"

namespace strandyn::study {

/// The measured cycles.
struct SteadyRun {
  Drive drive;
  bool tuned_at_shaker = true;
  std::vector<observe::Cycle> cycles;
  observe::Profile profile;  ///< over all of them
  std::complex<double> force, driven;
  Eigen::VectorXcd motion;             ///< deviation from rest
  Eigen::MatrixXcd curvature, moment;  ///< per section point and axis
  double modal_amplitude = 0;          ///< [m] |q|
};

struct BenchCost {
  std::size_t cycles_until_steady = 0;  ///< before the measured ones
  std::uint64_t evaluations_until_steady = 0;
  std::size_t steps = 0;  ///< of all
  int steps_per_cycle = 0;
};

struct BenchRun {
  SteadyRun steady;
  std::vector<double> decay;         ///< [m] |q| cycle by cycle after the shaker was let go
  std::vector<double> decay_losses;  ///< [J] friction and viscous, of the same cycles
  BenchCost cost;
  bool stopped = false;
};

struct BenchHooks {
  std::function<bool()> stop = {};                    ///< true: end early
  std::function<void(const std::string&)> tell = {};  ///< how far, in words
};

/// How many section evaluations a run from the mode will about take.
double expected_bench_evaluations(const casefile::Scene& scene, const Point& point);

/// Throws ComputationError where the vibration does not become steady, or an integration fails.
BenchRun run_bench(BenchSpan& bench, double antinode_amplitude, const BenchHooks& hooks);

}  // namespace strandyn::study
