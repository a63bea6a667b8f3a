#include "share.hpp"

#include <fmt/format.h>

#include <cmath>

namespace strandyn::study {

void check_numerical_share(const casefile::Scene& scene, const build::Integration& integration,
                           const VibrationPlan& plan, const ShareAccount& account, Outcome& outcome) {
  const auto& asked = scene.integrator.max_numerical_share;
  const bool applies = asked || account.cycles >= casefile::cycles_of_default_share;
  if (!applies || outcome.exit_code != ExitCode::done || !account.share) return;
  const double bound = asked.value_or(casefile::default_numerical_share);
  if (*account.share <= bound) return;
  const double allowed = bound * std::abs(account.numerical) / *account.share;
  const double more = integration.more_steps(account.numerical, account.quadrature_error, allowed);
  std::string remedy;
  if (integration.controls_error()) {
    remedy = "give a smaller integrator.rtol, or integrator.step = \"fixed\"";
  } else if (account.cycles == 0) {
    remedy = fmt::format("about integrator.step_s = {:.2g} would hold it", 0.95 * plan.step / more);
  } else {
    const double steps = std::ceil(1.05 * more * plan.steps_per_cycle() / 10) * 10;
    remedy = fmt::format("about integrator.steps_per_cycle = {:.0f} would hold it", steps);
  }
  outcome.exit_code = ExitCode::not_converged;
  outcome.message = fmt::format(
      "the integrator's own damping is {:.3g} of the physical dissipation{}, above the case's bound "
      "integrator.max_numerical_share = {:.3g}; {}",
      *account.share, account.cycles == 0 ? "" : " over the last cycles", bound, remedy);
}

std::vector<std::string> loss_columns(const casefile::Scene& scene) {
  std::vector<std::string> columns = {"viscous_dissipation_J", "friction_dissipation_J"};
  if (scene.material) columns.emplace_back("material_dissipation_J");
  if (scene.air) columns.emplace_back("air_dissipation_J");
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
