#include <fmt/format.h>

#include "parts.hpp"

namespace strandyn::study {

using json = nlohmann::ordered_json;

namespace {

/// "24.4 Hz, 220 steps per cycle, chosen for ...: the integrator's own damping ratio will be 5.8e-06"
std::string words(const casefile::Scene& scene, const VibrationPlan& plan) {
  if (plan.frequency == 0) return fmt::format("steps of {:.4g} s", plan.step);
  std::string text = fmt::format("{:.5g} Hz, ", plan.frequency);
  if (scene.integrator.step == casefile::StepRule::adaptive) {
    return text + fmt::format(
                      "steps by IDA's error control at {:.3g}, at least {:.0f} per cycle: their damping shows "
                      "in the ledger only",
                      scene.integrator.rtol, plan.steps_per_cycle());
  }
  text += fmt::format("{:.5g} steps per cycle", plan.steps_per_cycle());
  if (plan.expected_damping_ratio) {
    text += fmt::format(", chosen for a numerical share of {:.2g} % at an expected damping ratio of {:.3g}",
                        100 * plan.aimed_share, *plan.expected_damping_ratio);
  }
  return text + fmt::format(": the integrator's own damping ratio will be {:.3g}", *plan.numerical_damping_ratio);
}

}  // namespace

json plan_json(const VibrationPlan& plan) {
  json out = {{"step_s", plan.step}};
  if (plan.frequency > 0) {
    out["frequency_Hz"] = plan.frequency;
    out["steps_per_cycle"] = plan.steps_per_cycle();
  }
  if (plan.numerical_damping_ratio) out["predicted_numerical_damping_ratio"] = *plan.numerical_damping_ratio;
  if (plan.expected_damping_ratio) {
    out["expected_damping_ratio"] = *plan.expected_damping_ratio;
    out["aimed_numerical_share"] = plan.aimed_share;
  }
  return out;
}

void announce(const casefile::Scene& scene, const VibrationPlan& plan, const Hooks& hooks, CaseResult& result) {
  result.summary["plan"] = plan_json(plan);
  if (hooks.announce) hooks.announce(words(scene, plan));
}

}  // namespace strandyn::study
