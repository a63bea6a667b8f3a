#pragma once
/// \file Papailiou's layer: every wire sticks until its bending force reaches the belt-friction limit of its place.
///
///     stick       F_b = EA_w cos^2 a R sin(theta) chi
///     limit       F_b = F_0 [exp(+-mu |sin a| theta) - 1],   + on the tension side                 [Papailiou1997]
///     slip        chi(theta) = |limit|/(EA_w cos^2 a R |sin theta|)
///     moment      M = EI_min chi + cos a R sum over the n wires of F_b sin(theta)
/// theta is counted from the neutral plane, -pi/2 .. pi/2; F_0 is the wire force of the tension. With the wires at
/// discrete places M is a chain of straight lines whose kinks are the slip curvatures of the wires.
/// Range: one layer on a core, no residual forces, monotonic bending from the straight strand. The limit at theta holds
/// for the whole arc between neutral plane and wire, where `friction_layer` and the return map limit the gradient: the
/// wire force has kinks here, but full slip is the same.
/// Limits: chi(theta -> 0) = chi_cr = mu |sin a| F_0/(EA_w cos^2 a R); n -> infinity at full slip gives `full_slip`.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::exact {

class PapailiouLayer {
 public:
  /// A core and one layer under `tension` [N], twist held. Throws std::invalid_argument for any other strand.
  PapailiouLayer(const conductor::Strand& strand, double tension);

  double wire_force() const { return F_0_; }             ///< [N] without bending
  double first_slip() const;                             ///< [1/m] chi_cr, at the neutral plane
  double limit_force(double theta) const;                ///< [N] signed, |theta| <= pi/2
  double slip_curvature(double theta) const;             ///< [1/m] at which a wire there begins to slip
  double bending_force(double theta, double chi) const;  ///< [N] chi >= 0

  /// [N m] for n wires, the first at `theta_first`, the others evenly around; chi >= 0.
  double moment(double theta_first, double chi) const;
  /// [1/m] the kinks of that moment, ascending: one per wire that is not on the neutral plane.
  std::vector<double> kinks(double theta_first) const;

 private:
  std::vector<double> places(double theta_first) const;

  int wires_;
  double F_0_;          // [N]
  double m_;            // mu |sin a|
  double stick_slope_;  // [N m] EA_w cos^2 a R
  double arm_;          // [m] cos a R
  double EI_min_;       // [N m^2]
};

}  // namespace strandyn::exact
