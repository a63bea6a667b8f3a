#pragma once
/// \file A test bench in time: the span is brought to resonance at the wanted amplitude, measured in steady state, and
/// let go.
///
/// settle:  runs of a few cycles, each at one drive; after each the control says the next drive. Once amplitude and
///          phase are right the drive is held.
/// steady:  20 cycles at a held drive, all of like amplitude, in which what comes in is what is lost.
/// measure: N cycles more.
/// decay:   the shaker is let go: no force, or its point held where it was at rest.

#include "strandyn/build/method.hpp"
#include "strandyn/core/stop.hpp"
#include "strandyn/laboratory/instruments.hpp"

namespace strandyn::laboratory {

/// The measured cycles.
struct SteadyRun {
  Drive drive;
  bool tuned_at_shaker = true;
  double loss_exponent = 0;  ///< [-] of the loss over the amplitude, about the wanted one, by trial cycles: 1 to 8
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
  std::vector<double> decay_losses;  ///< [J] all physical losses of the same cycles
  BenchCost cost;
  bool stopped = false;
};

/// How the bench is run.
struct BenchOptions {
  bool starts_in_mode = true;         ///< at the wanted amplitude; else at rest, as in a laboratory
  int cycles = 20;                    ///< measured, once the vibration is steady
  int decay_cycles = 12;              ///< after the shaker is let go
  int max_cycles = 3000;              ///< until the vibration is steady
  double amplitude_tolerance = 2e-3;  ///< [-] of the wanted antinode amplitude
};

struct BenchHooks {
  Stop stop = {};                                     ///< true: end early
  std::function<void(const std::string&)> tell = {};  ///< how far, in words
  /// Sees every step from the first measured cycle on; it begins anew with each drive, at last with the decay.
  observe::Observer* watch = nullptr;
};

/// Throws ComputationError where the vibration does not become steady, or an integration fails.
BenchRun run_bench(BenchSpan& bench, double antinode_amplitude, const build::Integration& integration,
                   const BenchOptions& options, const BenchHooks& hooks);

}  // namespace strandyn::laboratory
