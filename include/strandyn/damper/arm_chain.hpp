#pragma once
/// \file An arm as a chain of beam elements, solved by harmonic balance (solver/periodic).
///
/// The clamp is a support that moves; the weight is an eccentric body at the last node. The chain moves across its line
/// only, its sections feel no axial strain: rotations are taken for small (0.1 rad at a strong resonance: 1 %), and
/// an end that is free to come nearer asks for no even harmonics, which an axially stiff chain would lack. A messenger
/// under 0.2 m long follows its weight nearly without inertia, so ten elements are plenty: the eight frequencies of two
/// dampers are within 1e-5 of the exact beam's. The metal's loss counts at the clamp's frequency, as one branch far
/// below its own: it adds a thousandth of the loss factor to the stiffness.

#include <optional>
#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/damper/damper.hpp"
#include "strandyn/model/model.hpp"
#include "strandyn/solver/periodic/periodic.hpp"

namespace strandyn::damper {

struct ArmChainOptions {
  std::size_t elements = 10;
  int harmonics = 3;
  int samples = 64;  ///< per cycle
  Stop stop = {};    ///< asked several times an iteration: Interrupted is thrown
};

class ArmChain {
 public:
  ArmChain(const Arm& arm, const Messenger& messenger, const ArmChainOptions& options = {});

  /// [Hz] the lowest natural frequencies across the line, all wires sticking.
  std::vector<double> natural_frequencies(std::size_t count) const;

  /// The steady answer, from the one before where there is one near by; ends in `failure` where Newton's method does
  /// not arrive, in smaller steps of frequency or amplitude either.
  ArmAnswer answer(const Shake& shake);
  /// Forgets the answer before.
  void start_anew() { last_.reset(); }

  /// Section points that a sample asks.
  std::size_t section_points() const;

 private:
  struct Reached {
    Shake shake;
    solver::PeriodicSolution solution;
  };
  /// From the motion of another shake, or from rest.
  solver::PeriodicSolution solve(const Shake& shake, const Reached* from, section::Effort& effort) const;
  /// The same in smaller steps where need be.
  solver::PeriodicSolution walk(const Reached& from, const Shake& to, int halvings, section::Effort& effort) const;
  model::Model model_at(double frequency) const;
  ArmAnswer answer_of(const Shake& shake, const solver::PeriodicSolution& solution) const;

  Arm arm_;
  Messenger messenger_;
  ArmChainOptions options_;
  std::optional<Reached> last_;
};

}  // namespace strandyn::damper
