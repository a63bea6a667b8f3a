#include "share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::study {

double energy_of(double kinetic, double elastic) {
  return std::max({kinetic, std::abs(elastic), kinetic + elastic});
}

ShareAccount account_of(const build::BuiltSpan& span, const observe::CycleObserver& cycles, std::size_t last) {
  ShareAccount account{
      .energy = cycles.ledger().now().initial_kinetic, .stored = stored_by_tension(span), .cycles = cycles.count()};
  for (const observe::Cycle& cycle : cycles.cycles()) {
    account.energy = std::max(account.energy, energy_of(cycle.kinetic, cycle.elastic));
  }
  const double count = static_cast<double>(last);
  for (const observe::Cycle& cycle : std::span(cycles.cycles()).last(last)) {
    account.numerical += cycle.numerical / count;
    account.quadrature_error += cycle.quadrature_error / count;
    account.lost += cycle.dissipated() / count;
  }
  return account;
}

void check_numerical_share(const casefile::Scene& scene, const build::Integration& integration,
                           const VibrationPlan& plan, const ShareAccount& account, Outcome& outcome) {
  if (outcome.exit_code != ExitCode::done) return;
  constexpr double nothing = 1e-12;  // of the energy: rounding
  // What the tension has stored is the scale of what rounding leaves of the elastic energy.
  if (std::abs(account.numerical) <= nothing * account.stored) return;
  const bool settled = account.cycles >= casefile::cycles_of_default_share && account.lost > nothing * account.energy;
  const double of_energy = casefile::part_of_energy * account.energy;
  const double reference = settled ? account.lost : std::max(account.lost, of_energy);
  const double bound = scene.integrator.max_numerical_share.value_or(casefile::default_numerical_share);
  const double share = std::abs(account.numerical) / reference;
  if (!(share > bound)) return;
  const double allowed = bound * reference;
  const double more = integration.more_steps(account.numerical, account.quadrature_error, allowed);
  std::string remedy;
  if (account.has_blows) {
    remedy = "no step holds it while the velocity of a support jumps: ease the motion in, or give it without corners";
  } else if (integration.controls_error()) {
    remedy = "give a smaller integrator.rtol, or integrator.step = \"fixed\"";
  } else if (plan.frequency == 0) {
    remedy = fmt::format("about integrator.step_s = {:.2g} would hold it", 0.95 * plan.step / more);
  } else {
    // Too few steps to show how their error falls tell nothing of how many would do.
    const double few = casefile::default_steps_per_cycle / 4.0;
    double steps = std::ceil(1.05 * more * plan.steps_per_cycle() / 10) * 10;
    if (plan.steps_per_cycle() < few) steps = std::max<double>(steps, casefile::default_steps_per_cycle);
    remedy = fmt::format("about integrator.steps_per_cycle = {:.0f} would hold it", steps);
  }
  outcome.exit_code = ExitCode::not_converged;
  outcome.message = fmt::format(
      "the integrator's own part is {:.3g} of {}{}, above the case's bound integrator.max_numerical_share = {:.3g}; {}",
      share,
      reference == account.lost ? "the physical dissipation"
                                : fmt::format("{:g} % of the greatest energy", 100 * casefile::part_of_energy),
      account.cycles == 0 ? "" : " per cycle over the last cycles", bound, remedy);
}

double stored_by_tension(const build::BuiltSpan& span) {
  return span.tension * span.tension * span.length / (2 * span.numbers.EA);
}

std::vector<std::string> loss_columns(const casefile::Scene& scene) {
  std::vector<std::string> columns = {"viscous_dissipation_J", "friction_dissipation_J"};
  if (scene.material) columns.emplace_back("material_dissipation_J");
  if (scene.air) columns.emplace_back("air_dissipation_J");
  if (!scene.dampers.empty()) columns.emplace_back("damper_dissipation_J");
  return columns;
}

void add_effort(const system::System& system, Cost& cost) {
  cost.residual_evaluations = system.residual_evaluations();
  cost.jacobian_evaluations = system.jacobian_evaluations();
  cost.section_evaluations = system.effort().evaluations;
  cost.section_sweeps = system.effort().sweeps;
}

void add_integration(const solver::IntegratorSummary& run, const system::System& system, Outcome& outcome) {
  outcome.cost.steps = run.steps;
  outcome.cost.rejected_steps = run.rejected_steps;
  outcome.cost.order_one_steps = run.order_one_steps;
  outcome.cost.newton_iterations = run.newton_iterations;
  add_effort(system, outcome.cost);
  if (run.order_one_steps == 0) return;
  outcome.warnings.push_back(fmt::format(
      "{} steps fell back to order 1, which damps strongly: the numerical part shows how much", run.order_one_steps));
}

}  // namespace strandyn::study
