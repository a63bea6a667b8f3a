#pragma once
/// \file A Stockbridge damper held at its clamp: two arms of messenger strand, a weight at the end of each.
///
/// The clamp moves across the line as y = Re[V/(i w) exp(i w t)] and does not turn, as on the shaker of IEC 61897. An
/// arm asks the clamp for a force F exp(i w t); with those of both arms and the clamp's own mass,
///     Z = F/V     impedance [N s/m], its phase is that of the force ahead of the velocity
///     P = |V|^2 Re Z/2     power [W], what messenger and metal lose
/// Two ways to F: the arm as a chain of beam elements (arm_chain.hpp), and one element with two unknowns
/// (reduced_arm.hpp). The messenger is a strand without tension, bent by its weight's inertia; its section law is any
/// of this program's. Gravity is left out: the weight's static moment preloads the messenger, and a law with Coulomb
/// friction forgets it after a few cycles.

#include <complex>
#include <memory>
#include <numbers>
#include <string>

#include "strandyn/section/law.hpp"
#include "strandyn/section/material_damping.hpp"

namespace strandyn::damper {

using Complex = std::complex<double>;

/// The rigid body at the end of the messenger.
struct Weight {
  double mass = 0;          ///< [kg]
  double inertia = 0;       ///< [kg m^2] about its own centre, out of the plane
  double eccentricity = 0;  ///< [m] its centre, from the messenger's end towards the clamp
};

/// What both arms are made of. Planar.
struct Messenger {
  std::shared_ptr<const section::Law> law;
  double mass_per_length = 0;           ///< [kg/m]; >= 0
  section::MaterialLoss material = {};  ///< counts at the frequency of the clamp
};

struct Arm {
  double length = 0;  ///< [m] of messenger from the clamp to the end in the weight
  Weight weight;
};

/// The motion of the clamp: a sine.
struct Shake {
  double frequency = 0;  ///< [Hz]
  double velocity = 0;   ///< [m/s] amplitude V, real: it sets the phase

  double omega() const { return 2 * std::numbers::pi * frequency; }  ///< [rad/s]
  double displacement() const { return velocity / omega(); }         ///< [m] amplitude
};

/// How an arm answers, once its vibration has become steady.
struct ArmAnswer {
  bool converged = false;
  std::string failure;  ///< why not, in words
  Shake shake;
  Complex force = 0;           ///< [N] on the arm at the clamp, V real
  Complex tip = 0;             ///< [m] of the messenger's end, from its rest in space, V real
  Complex turn = 0;            ///< [rad] of the weight
  double clamp_curvature = 0;  ///< [1/m] amplitude of the messenger's fundamental at the clamp
  double friction = 0;         ///< [J] per cycle
  double material = 0;         ///< [J] per cycle
  section::Effort effort = {};

  Complex impedance() const { return force / shake.velocity; }          ///< [N s/m]
  double power() const { return 0.5 * shake.velocity * force.real(); }  ///< [W]
};

}  // namespace strandyn::damper
