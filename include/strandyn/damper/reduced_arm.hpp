#pragma once
/// \file An arm with two unknowns: the messenger is one cubic element, its weight's displacement w and rotation phi.
///
/// Between clamp (displacement y, no rotation) and weight the curvature is linear,
///     chi(x) = (6/l^2 - 12 x/l^3) (w - y) + (6 x/l^2 - 2/l) phi
/// and each place has the complex stiffness of its own amplitude, EI*(|chi(x)|) of bending_loops.hpp and the metal's
/// loss. One harmonic:
///     [K*(w, phi) - w^2 M] (y, w, phi) = (F, 0, 0)
/// with the messenger's own consistent mass in M. Against the chain it leaves out the other harmonics, and how a
/// stretch that slips more takes more of the bending. Two Hermite arms with a constant EI* are its closed form.

#include <array>

#include "strandyn/damper/bending_loops.hpp"
#include "strandyn/damper/damper.hpp"

namespace strandyn::damper {

class ReducedArm {
 public:
  /// `loops` of the messenger's law must outlive it.
  ReducedArm(const Arm& arm, const Messenger& messenger, const BendingLoops& loops);

  /// As ArmChain::answer; `effort` stays zero, the loops have their own.
  ArmAnswer answer(const Shake& shake);
  void start_anew() { has_last_ = false; }

 private:
  using Unknowns = std::array<Complex, 2>;  // w - y, phi; y real
  struct Force {
    Complex clamp;                      // [N]
    Unknowns on_weight;                 // [N], [N m] out of balance
    double friction = 0, material = 0;  // [J] per cycle
  };
  Force force_at(const Shake& shake, const Unknowns& x) const;
  bool solve(const Shake& shake, Unknowns& x) const;

  Arm arm_;
  Messenger messenger_;
  const BendingLoops& loops_;
  bool has_last_ = false;
  Unknowns last_ = {};  // per displacement of the clamp
};

}  // namespace strandyn::damper
