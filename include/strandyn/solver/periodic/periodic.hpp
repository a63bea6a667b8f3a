#pragma once
/// \file The steady response of a chain to a harmonic drive, solved directly: harmonic balance, friction by its loops.
///
///     u(t) = u_0 + sum_k [c_k cos(k w t) + s_k sin(k w t)],  k = 0..H
///     R_k = k-th harmonic of [ M u'' + g + C u' + f_int(u; loop) - f_ext ] = drive A cos(w t), k = 1, or 0
/// The harmonics of the friction come from N samples of the cycle: the section law is led once around from the
/// committed history, and then around its closed loop, which is the one that counts.                  [Cameron &
/// Griffin 1989]
///
/// Near resonance the matrix of the fundamental is singular but for the damping, of which there may be 1e-5 or none. So
/// the swing z = c + i s of one unknown, the control, is held like the frequency w and the drive A. What is left is a
/// chain with one more support, well away from its own resonances where the control is an antinode. Its balance there
/// and two closing equations find z, w, A:
///     resonance   |z| = Y, and the driven unknown a quarter of a cycle behind the force (moved support: the control
///                 a quarter behind the motion): force in phase with velocity, as a laboratory tunes its shaker
///     forced      w and A given
///     sweep       A given and a step along the curve (z, w): it passes folds
/// Newton's matrix couples all harmonics of neighbouring nodes. Geometry is exact: the tension that swings with the
/// span, too. So is the answer of sections that slip, all harmonics of the moment to all of the curvature, by leading
/// the loops around once more per coefficient; it is kept while the corrections fall fast. Where nothing slips it is
/// the tangent at rest and costs nothing.
///
/// Still air and the metal of the wires answer each harmonic at its own frequency; parts of the air's force that are
/// not linear are taken at that of the fundamental.
///
/// Power: drive = work of the section loops + losses to metal, viscous damping and air per cycle, an identity of the
/// converged state whatever N and H are. The work of the loop differs from the friction that the law booked by its
/// quadrature error, O(1/N^2).

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::solver {

/// An unknown of the chain.
struct Place {
  std::size_t node = 0;
  model::Unknown unknown = model::Unknown::y;
};

enum class DriveKind {
  force,  ///< on a free unknown; drive amplitudes in N (N m)
  motion  ///< of a held unknown; drive amplitudes in m (rad)
};

struct PeriodicSetup {
  DriveKind kind = DriveKind::force;
  Place drive;
  Place control;  ///< free, near an antinode of the response: its fundamental is "the amplitude"
};

struct PeriodicOptions {
  int harmonics = 3;  ///< H; take 5 in gross slip: with 3 the loss of a 30 m span was 1 % and 4 % low there
  int samples = 64;   ///< N per cycle
  /// Of a correction, relative to amplitude, frequency and drive; of very small motions what rounding leaves, 2e-16 of
  /// the chain's length over the amplitude.
  double tolerance = 1e-9;
  int max_iterations = 40;  ///< per state
  int max_cycles = 10;      ///< in which a section loop must close
  double closure = 1e-9;    ///< [-] gap of a closed loop, of the largest resultant of its kind
  double probe = 1e-4;      ///< [-] of the fundamental curvature: how far sections are asked for their derivatives
  Stop stop = {};           ///< asked several times an iteration; a solution then ends by Interrupted
  /// Throws std::invalid_argument that names the option.
  void validate() const;
};

/// What slipping sections answer to a change of their curvatures; only the solver that found it can read it.
struct SectionModel;

struct PeriodicState {
  double frequency = 0;  ///< [Hz]
  double drive = 0;      ///< A [N] or [m]
  /// Deviation from rest: one row per unknown, columns mean, cos 1, sin 1, cos 2, ... [m], [rad]
  Eigen::MatrixXd harmonics;
  /// Of a solution: Newton's method begins with it at a neighbour, on another mesh or with other harmonics, too. Empty:
  /// found anew.
  std::shared_ptr<const SectionModel> sections = {};

  /// u_k = c - i s of unknown i: its motion is Re(u_k exp(i k w t)); the drive is A exp(i w t).
  std::complex<double> phasor(std::size_t i, int k = 1) const;
};

/// Along the span, one entry per section point.
struct SectionLoss {
  std::vector<double> loop_work;            ///< [J/m] per cycle: area of the loops, of all resultants
  std::vector<double> friction;             ///< [J/m] per cycle, as the law books it; >= 0
  std::vector<double> quadrature_error;     ///< [J/m] per cycle, of the friction
  std::vector<double> material;             ///< [J/m] per cycle, of the metal; >= 0
  std::vector<double> curvature_amplitude;  ///< [1/m] of the fundamental, of both axes together
};

struct PeriodicSolution {
  bool converged = false;
  std::string failure;  ///< what went wrong and where; empty where converged
  PeriodicState state;
  double amplitude = 0;  ///< [m] |z| of the control
  int iterations = 0;
  double residual = 0;    ///< [N] largest harmonic out of balance
  double correction = 0;  ///< [-] the last one, as the tolerance measures it
  section::Effort effort = {};
  int cycles = 0;                        ///< until the loops were closed
  double loop_gap = 0;                   ///< [-] as `closure` measures it
  std::complex<double> drive_force = 0;  ///< [N] or [N m] on the driven unknown: Re(F exp(i w t))
  double drive_power = 0;                ///< [W]
  double loop_work = 0;                  ///< [J] per cycle, all sections
  double friction = 0;                   ///< [J] per cycle, all sections, as the law books it
  double quadrature_error = 0;           ///< [J] per cycle, of the friction
  double material = 0;                   ///< [J] per cycle, all sections
  system::ViscousLoss viscous;           ///< [J] per cycle
  double air = 0;                        ///< [J] per cycle
  SectionLoss sections;
  std::vector<double> air_by_node;  ///< [J] per cycle

  /// Drive power less all losses, relative to it. Means nothing where nothing is lost.
  double imbalance() const;
};

struct SweepOptions {
  double from = 0, to = 0;      ///< [Hz], either way
  double drive = 0;             ///< A
  double frequency_step = 0;    ///< [Hz] largest
  double swing_step = 0.25;     ///< [-] largest change of z in parts of itself
  double smallest_step = 1e-4;  ///< of the largest, before the sweep gives up
  std::size_t max_points = 1000;
  /// Hears of every point as it is found; false ends the sweep there. Empty: nobody listens.
  std::function<bool(const PeriodicSolution&)> each = {};
};

/// A node (smallest) or antinode (largest) of the fundamental's envelope.
struct LoopPoint {
  bool antinode = false;
  double position = 0;   ///< [m] along the reference configuration
  double amplitude = 0;  ///< [m]
};

/// Along a chain whose unknowns move as Re(motion exp(i w t)), across it in one direction, y or z.
std::vector<LoopPoint> loop_points(const model::Model& model, model::Unknown across, const Eigen::VectorXcd& motion);

/// Keeps to the committed history of the system, which it never writes. One object serves one thread.
class PeriodicSolver {
 public:
  /// `rest` is the state of equilibrium at which the history of `system` was committed. Loads that change with time
  /// count with their value at time 0: a harmonic one not at all.
  PeriodicSolver(const system::System& system, system::Vector rest, PeriodicSetup setup, PeriodicOptions options = {});

  /// The mode swinging by `amplitude` at the control, at its frequency: a start.
  PeriodicState from_mode(const Mode& mode, double amplitude) const;
  /// At rest under the drive.
  PeriodicState from_rest(double frequency, double drive) const;

  /// Phase resonance at amplitude Y > 0.
  PeriodicSolution resonance(double amplitude, const PeriodicState& start) const;
  /// Resonance at each amplitude, each from the one before, in smaller steps where need be; ends with the first that
  /// fails.
  std::vector<PeriodicSolution> backbone(const std::vector<double>& amplitudes, const Mode& mode) const;
  /// Given frequency and drive, from `start` or from rest.
  PeriodicSolution forced(double frequency, double drive) const;
  PeriodicSolution forced(double frequency, double drive, const PeriodicState& start) const;
  /// Along the curve of given drive from one frequency to the other, around folds; ends with the first that fails.
  std::vector<PeriodicSolution> sweep(const SweepOptions& sweep) const;

  /// Along the chain, in the direction of the control (y or z).
  std::vector<LoopPoint> loop_points(const PeriodicState& state) const;

 private:
  PeriodicSolution follow(const PeriodicSolution& from, double amplitude, int halvings) const;

  const system::System& system_;
  system::Vector rest_;
  PeriodicSetup setup_;
  PeriodicOptions options_;
};

}  // namespace strandyn::solver
