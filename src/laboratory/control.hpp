#pragma once
/// \file How a test bench is steered: the drive's frequency to resonance, its amplitude to that of the antinode.
///
/// Over a few cycles the mode's coordinate Re(q exp(i w t)) under the drive A cos(w t) follows
///     q' = i (w_0 - w) q - lambda q - i A c/(2 w m)
/// so that two readings of q tell the frequency w_0 that the span has at this amplitude, and the rate lambda at which
/// it loses its amplitude. With them the next drive is the one that brings amplitude and phase to what is wanted by the
/// end of the next run of tau: nothing is to be tuned, whatever the damping is.
///     w = w_0 - lambda tan(theta*) + (theta - theta*)/tau,      theta: how far q is from a quarter cycle behind
///     A = 2 w m [lambda_Q Q + step mu/(exp(mu tau) - 1)]/(c cos(theta)),     Q = |q| + step
/// The loss goes with a power p of the amplitude, 2 if it is viscous: lambda_Q = lambda (Q/|q|)^(p - 2), and what the
/// amplitude is off by dies out with mu = (p - 1) lambda.
/// Resonance: a force is in phase with the velocity of its point, a motion a quarter cycle before the antinode. The
/// point of a force moves by x = c q + R A, the other modes' share with it; it is a quarter behind where
///     sin(2 theta*) = -4 w m lambda R/c^2
/// Beyond 1 there is no such frequency: the damping is too large for a force there, and the antinode is tuned instead.
/// Tuned there the sine is another one, and may be below 1 again. A first reading is one of a span that has not come to
/// its swing yet, so it may go back to the shaker once; then the antinode it is. (It went to and fro for 3000 cycles.)

#include <complex>
#include <vector>

#include "strandyn/laboratory/bench_span.hpp"

namespace strandyn::laboratory {

/// Of the mode on the bench.
struct Plant {
  double modal_mass = 0;  ///< [kg]
  double coupling = 0;    ///< c
  bool moves = false;     ///< the shaker: a motion, else a force
  double exponent = 2;    ///< p, about the wanted amplitude
};

/// Of a run at one drive; phasors against a drive of phase 0.
struct RunReading {
  Drive drive;
  std::complex<double> first, last;  ///< [m] q, the means of two cycles
  double between = 0;                ///< [s] the middles of these two
  double after = 0;                  ///< [s] from the middle of the last one to the end of the run
  std::complex<double> driven;       ///< [m] the shaker's point, mean of the last cycle
  double antinode_amplitude = 0;     ///< [m] mean from the first to the last
};

class Control {
 public:
  Control(const Plant& plant, double antinode_amplitude) : plant_(plant), wanted_(antinode_amplitude) {}

  void read(const RunReading& reading);
  /// Brings the span nearer to what is wanted, within a time [s].
  Drive corrected(double time) const;
  /// Holds it where it is wanted: once it is there, it stays.
  Drive held() const;
  /// The drive of each cycle, as parts of the held one, on the way to letting go: evenly up for n cycles and down to
  /// nothing for n, a round trip of a wave, so that the amplitude is `above` [-] what is wanted when the drive has
  /// gone. A force that lets go at once leaves the neighbouring modes swinging, which beat with the losses: even steps
  /// over n cycles strike none.
  std::vector<double> way_out(std::size_t n, double above) const;

  double amplitude_error() const { return amplitude_error_; }    ///< [-] of the wanted amplitude
  double phase_error() const { return phase_ - phase_wanted_; }  ///< [rad]
  bool tuned_at_shaker() const { return !plant_.moves && at_shaker_; }

 private:
  Drive drive_at(double omega, double push, double phase) const;
  double rate_at(double modal_amplitude) const;

  Plant plant_;
  double wanted_;
  double omega_ = 0;                     // [rad/s] w_0
  double rate_ = 0;                      // [1/s] lambda
  double modal_ = 0, modal_wanted_ = 0;  // [m] |q| at the end of the run, and where the antinode is as wanted
  double phase_ = 0, phase_wanted_ = 0;  // [rad] theta, theta*
  double amplitude_error_ = 1;
  bool at_shaker_ = true;
  int returns_ = 0;  // to the shaker
};

}  // namespace strandyn::laboratory
