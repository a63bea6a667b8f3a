#pragma once
/// \file What a method of integration does: one accepted step after the other. The loop does everything else.

#include <memory>
#include <optional>
#include <string>

#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::solver {

/// The step that was accepted last.
struct StepTaken {
  double time = 0;    ///< [s] its end
  double length = 0;  ///< [s]
  int order = 0;
};

/// Where it gave up.
struct StepFailure {
  double length = 0;         ///< [s] of the last attempt
  std::optional<int> order;  ///< where it changes
  std::string corrections;   ///< the largest, by name of their unknowns
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Takes one step, not beyond `stop` [s]. False where it gave up: the state is then that of the step before.
  virtual bool step(double stop) = 0;
  virtual StepTaken last() const = 0;
  virtual const system::Vector& u() const = 0;
  virtual const system::Vector& v() const = 0;
  virtual const system::Vector& a() const = 0;

  /// Begins anew from the state at hand: loads or motions have a corner there.
  virtual void restart() = 0;
  /// Exchanges long rotation vectors. True where there was one: `restart` must follow.
  virtual bool shorten_rotations() = 0;
  /// Between two steps. A stepper that reads must be new.
  virtual void archive(Archive& a) = 0;

  virtual StepFailure failure() const = 0;
  virtual std::size_t rejected_steps() const = 0;
  virtual std::size_t newton_iterations() const = 0;
};

std::unique_ptr<Stepper> make_stepper(const Ida& method, system::System& system, const InitialMotion& initial,
                                      const IntegratorOptions& options);
std::unique_ptr<Stepper> make_stepper(const GeneralizedAlpha& method, system::System& system,
                                      const InitialMotion& initial, const IntegratorOptions& options);

}  // namespace strandyn::solver
