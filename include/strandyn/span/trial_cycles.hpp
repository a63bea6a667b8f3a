#pragma once
/// \file How strongly a vibration will be damped, before it is integrated: trial cycles of the mode's shape.
///
/// The sections are led twice around u = u_0 + A phi sin(tau) without any dynamics; the second time counts. With the
/// viscous loss of the velocity A omega phi cos(tau) and the energy E = (A omega)^2 phi . M phi/2 of the mode:
///     zeta(A) = (friction + losses to metal, viscous forces and air per cycle)/(4 pi E)

#include "strandyn/core/stop.hpp"
#include "strandyn/span/rest.hpp"

namespace strandyn::span {

class TrialCycles {
 public:
  /// `shape` [m, rad]: the mode at an antinode amplitude of 1 m. What follows throws Interrupted where it is stopped.
  TrialCycles(const SpanAtRest& span, const system::Vector& shape, double frequency, Stop stop = {});

  /// [J] per cycle at an antinode amplitude [m].
  double loss(double amplitude);
  double damping_ratio(double amplitude);
  /// [m] amplitude at which a force [N] in phase with the velocity feeds what is lost; `drive` [-] is the shape along
  /// the force where it acts.
  double steady_amplitude(double force, double drive);
  /// [m] amplitude after a number of cycles of free decay.
  double decayed_amplitude(double amplitude, std::size_t cycles);

 private:
  const SpanAtRest& span_;
  system::System trial_;
  system::Vector shape_;
  double omega_;
  double modal_mass_;
  Stop stop_;
};

}  // namespace strandyn::span
