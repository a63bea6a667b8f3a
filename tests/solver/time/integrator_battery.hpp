#pragma once
/// \file The battery: what every time integrator must do, in one call.
///
///     TEST_CASE("battery: generalized alpha") { check_integrator(generalized_alpha(0.9), 0.15); }

#include <functional>

#include "solver/vibration.hpp"
#include "strandyn/solver/time/integrator.hpp"

namespace strandyn::test {

using Integrator =
    std::function<solver::IntegratorSummary(system::System&, const solver::InitialMotion&,
                                            const solver::IntegratorOptions&, std::span<observe::Observer* const>)>;

Integrator ida();
Integrator generalized_alpha(double rho_inf);

/// Keeps what a run went through.
class Trace final : public observe::Observer {
 public:
  void begin(const system::System& system, const observe::StepRecord& initial) override { step(system, initial); }
  void step(const system::System& system, const observe::StepRecord& record) override;

  double loss() const { return energy.front() - energy.back() - friction; }  ///< [J] what nobody has booked

  std::vector<double> time, steps;
  std::vector<int> order;
  std::vector<system::Vector> u, v;
  std::vector<double> energy;  ///< [J] kinetic and elastic
  double friction = 0;         ///< [J]
  std::function<void(const system::System&, const observe::StepRecord&)> also = {};
};

/// Runs all checks below. `order_within`: how near to 2 the order shows at moderate steps.
void check_integrator(const Integrator& integrator, double order_within);

/// Four times smaller errors of displacements and velocities at half the step: small and large swings, massless
/// rotations, lumped and consistent mass, drag, moving supports, tables with corners, free flight in space.
void check_order(const Integrator& integrator, double within);
/// The first record is the initial state, steps add up, whole cycles are met, and the last step ends at the end.
void check_time(const Integrator& integrator);
/// Friction takes energy, laws without it take none, and what nobody has booked is small beside it.
void check_balance(const Integrator& integrator);
/// Held unknowns are where their motions say, at the speed that these have.
void check_held(const Integrator& integrator);
/// A load and a motion that follow drives of the run move as those of a fixed history do, to the bit.
void check_drives(const Integrator& integrator);
/// The same run gives the same bits; it ends when it is told to; a failure names time and nodes; an exception of the
/// law comes out as it was thrown.
void check_endings(const Integrator& integrator);

}  // namespace strandyn::test
