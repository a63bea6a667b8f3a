#pragma once
/// \file A span with one harmonic drive, its shaker, in periodic vibration near one of its modes: what the
/// periodic method of a self-damping study and the sweep share.

#include <functional>
#include <optional>

#include "strandyn/build/shaker.hpp"
#include "strandyn/observe/deflection_points.hpp"
#include "strandyn/solver/periodic/periodic.hpp"
#include "strandyn/span/modes.hpp"

namespace strandyn::span {

/// How a periodic response is solved.
struct ResponseOptions {
  int harmonics = 5;
  int samples = 64;         ///< per cycle
  double tolerance = 1e-8;  ///< [-] of the last correction
  Stop stop = {};           ///< asked within a response
};

/// A resonance at a wanted antinode amplitude.
struct ResonanceAt {
  solver::PeriodicSolution solution;
  double antinode_amplitude = 0;  ///< [m] that was reached
  section::Effort effort;         ///< of all attempts
  bool stopped = false;
};

/// Losses between the first and the last inner node.
struct FreeSpan {
  double from = 0, to = 0;  ///< [m] along the span
  double friction = 0;      ///< [J] per cycle
  double material = 0;      ///< [J] per cycle
  double air = 0;           ///< [J] per cycle
  double curvature = 0;     ///< [1/m] amplitude of the sine that has the same mean square
  double highest = 0;       ///< [1/m] largest half of peak to peak, all harmonics counted
};

/// Strains over a cycle.
struct StrainRange {
  double mean_tension = 0, highest_tension = 0;  ///< [N]
  std::vector<double> curvature;                 ///< [1/m] half of peak to peak, per section point
};

class ShakenSpan {
 public:
  /// Takes the mode across the span, in its plane, that is nearest to `frequency` [Hz]. Throws Interrupted where it is
  /// stopped.
  ShakenSpan(build::BuiltSpan built, const build::Shaker& shaker, double frequency, const ResponseOptions& options);

  const SpanAtRest& span() const { return span_; }
  const solver::Mode& mode() const { return mode_; }
  int mode_number() const { return mode_number_; }
  const solver::PeriodicSolver& solver() const { return *solver_; }
  solver::DriveKind drive_kind() const { return setup_.kind; }

  /// [m] half of peak to peak at the largest antinode away from the ends.
  double antinode_amplitude(const solver::PeriodicState& state) const;
  /// [rad] by which the driven point follows the force (the control a moved support), -pi/2 to 3 pi/2; a quarter of a
  /// turn at phase resonance.
  double phase(const solver::PeriodicState& state) const;
  /// Phase resonance at an antinode amplitude [m]: straight from the mode, or in steps of amplitude where that fails.
  ResonanceAt resonance(double antinode_amplitude) const;
  /// The same, begun at a resonance of the same chain on this mesh or another, with as many harmonics or others; where
  /// that leads nowhere, at the mode.
  ResonanceAt resonance(double antinode_amplitude, const ShakenSpan& other, const solver::PeriodicState& found) const;
  /// Nothing below three loops.
  std::optional<FreeSpan> free_span(const solver::PeriodicSolution& solution, const StrainRange& strains) const;
  StrainRange strains(const solver::PeriodicState& state) const;

 private:
  /// Up to the control's amplitude in so many parts of it; or from a state that is near.
  void from_mode(const solver::PeriodicSolver& solver, double control, int parts, ResonanceAt& result) const;
  void from(const solver::PeriodicSolver& solver, double control, solver::PeriodicState start,
            ResonanceAt& result) const;
  void approach(double antinode_amplitude, ResonanceAt& result) const;
  void settle(double antinode_amplitude, ResonanceAt& result) const;

  SpanAtRest span_;
  solver::Mode mode_;
  int mode_number_ = 0;
  solver::PeriodicSetup setup_;
  solver::PeriodicOptions options_;
  std::optional<observe::DeflectionPoints> places_;
  std::optional<solver::PeriodicSolver> solver_;
};

/// [J] per cycle: what friction takes, by the area of the loops. It balances with the drive whatever the samples are,
/// and is exactly zero where nothing slips.
double friction_of(const solver::PeriodicSolution& solution);
/// All that is self-damping: friction, the metal of the wires, viscous losses. Not the air. [J] per cycle
double losses_of(const solver::PeriodicSolution& solution);

}  // namespace strandyn::span
