#pragma once
/// \file Wind across a chain, in time. It acts on motion along y.
///
/// **Locked in** to a mode phi of frequency f: per length acts
///     F = c v_f,   c = 4 f^3 D^4 fnc(a) B/(omega^2 A^2) = f D^2 B fnc(a)/(pi^2 a^2),   a = A/D
/// so that a sine loop is fed f^3 D^4 fnc(a) B per metre, the mean of c omega^2 A^2 sin^2(k x)/2. v_f is what of the
/// velocity of the place goes in step with the mode, because vortices that are locked to one vibration feed no other: c
/// v would be a negative damping of all modes, and the one that is damped least would win. With the mode's coordinate
/// q = phi . M (u - rest)/(phi . M phi) and its phasor p = (q' + i omega q)/|.|,
///     v_f = Re(V p),   V <- V + (1 - exp(-h/tau)) (2 v conj(p) - V) at every commit
/// V, the complex amplitude of each node, is the history: the shape may be another than phi, where dampers shift it or
/// lead a wave away, and the frequency follows the vibration. tau is n periods in mode n, a round trip of the wave, and
/// no less than ten: a neighbouring mode then drops to some hundredths. A is the amplitude of that loop's antinode,
///     A^2 = sum l |V/omega|^2/(sum l phi^2) max phi^2        over the nodes of the loop with their lengths l
/// Below the range of the curve c stays what it is at its end, where fnc/a^2 would go to infinity: small vibrations
/// grow at one rate. Above it fnc stays what it is at its end.
///
/// **Wake oscillators** (air/wake_oscillator.hpp), one a node: the history is q and q' of each, the acceleration of the
/// last commit and its time; over a step the answer is that to the trial acceleration at its end.
///
/// The work of the wind is booked as its power v . F.

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "strandyn/core/archive.hpp"
#include "strandyn/math/chain_matrix.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::system {

struct State;

class WindOnChain {
 public:
  virtual ~WindOnChain() = default;
  /// f -= F at all nodes [N], for a trial state at a time [s].
  virtual void subtract_force(const State& state, double time, double* f) const = 0;
  /// K -= factor dF/dv, as far as it lies in the blocks of a node. How the force follows the mode, amplitude and
  /// acceleration is left out: a thousandth of the inertia.
  virtual void subtract_tangent(double /*factor*/, math::ChainMatrix& /*K*/) const {}
  /// [W] v . F of an accepted state.
  virtual double power(const State& state) const = 0;
  /// Accepts the state as the end of a step.
  virtual void commit(const State& state, double time) = 0;
  virtual void archive(Archive& a) = 0;
};

/// The mode to which the vortices are locked: its frequency [Hz], its shape at any scale and M times it, all unknowns,
/// and the state of rest about which it swings.
struct LockedMode {
  double frequency = 0;
  std::size_t number = 1;  ///< n, of half waves
  Eigen::VectorXd shape, momentum, rest;
  double velocity = 0;  ///< [m/s] factor of the shape with which the mode begins
};

/// `model` must outlive it; it has wind of that kind.
std::unique_ptr<WindOnChain> make_locked_in_wind(const model::Model& model, const LockedMode& mode);
std::unique_ptr<WindOnChain> make_wake_wind(const model::Model& model);

}  // namespace strandyn::system
