#pragma once
/// \file The beam by which programs are compared: a straight span that starts as a sine of twelve loops.
///
/// 30 m unstressed, stretched by 22.5 mm to 30 kN, clamped, 1.98 kg/m. The case files hold the numbers; only the sine,
/// v = 0.8 sin(12 pi j/n) m/s at node j, and the rotation rates that match it, are made here.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/build/span.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::bench {

/// A span built from a case below cases/, at rest.
struct Span {
  Span(const std::string& name, const std::vector<std::string>& overrides);

  casefile::Scene scene;
  build::BuiltSpan built;
  system::System system;
  system::Vector u;
};

/// Velocities of a sine of `loops` loops. [m/s], [rad/s]
system::Vector sine_velocity(const Span& span, int loops, double antinode_velocity);

/// Integrates with the method of the case.
solver::IntegratorSummary integrate(Span& span, const system::Vector& velocity, double step, std::size_t steps,
                                    std::span<observe::Observer* const> observers = {});

/// Sum of M dkappa over all sections, trapezoidal: what bending has taken, stored part included. [J]
class BendingWork final : public observe::Observer {
 public:
  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;
  double work() const { return work_; }

 private:
  section::Field curvatures_, moments_;
  system::Vector force_;
  double work_ = 0;
};

}  // namespace strandyn::bench
