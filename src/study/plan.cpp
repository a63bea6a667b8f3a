#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "expected_damping.hpp"
#include "integration.hpp"
#include "parts.hpp"
#include "strandyn/observe/deflection_points.hpp"

namespace strandyn::study {

using casefile::AnalysisType;
using casefile::refuse;
using casefile::Scene;

namespace {

constexpr std::size_t most_cycles_until_steady = 5000;

/// The highest mode number that the scene speaks of; 0 if it names none.
int highest_mode(const Scene& scene) {
  int highest = 0;
  for (const casefile::Load& load : scene.loads) highest = std::max(highest, load.frequency_mode.value_or(0));
  for (const casefile::Motion& motion : scene.motions) highest = std::max(highest, motion.frequency_mode.value_or(0));
  if (scene.initial) highest = std::max(highest, scene.initial->velocity_mode);
  if (scene.analysis.type == AnalysisType::decay) highest = std::max(highest, scene.analysis.decay.mode);
  return highest;
}

/// What the span asks of its drives, with the frequencies of the modes.
std::vector<model::Drive> find_drives(const SpanAtRest& span, const std::vector<solver::Mode>& modes) {
  std::vector<model::Drive> drives;
  for (const build::DriveAsk& ask : span.built.drives) {
    drives.push_back({.frequency = ask.mode ? modes[static_cast<std::size_t>(*ask.mode) - 1].frequency
                                            : ask.frequency.value_or(0)});
  }
  return drives;
}

/// The lowest physical damping that the run will see: that of its smallest amplitude.
double expected_damping(const Scene& scene, SpanAtRest& span, const system::Vector& shape, const VibrationPlan& plan) {
  if (shape.size() == 0) return 0;
  TrialCycles trial(span, shape, plan.frequency);
  const double velocity = observe::DeflectionPoints(span.built.model, 0).largest(plan.velocity.data());
  double amplitude = velocity / (2 * std::numbers::pi * plan.frequency);
  if (scene.analysis.type == AnalysisType::decay) {
    const double late = trial.damping_ratio(trial.decayed_amplitude(amplitude, plan.cycles));
    return late > 0 ? late : trial.damping_ratio(amplitude);
  }
  for (const model::Load& load : span.built.model.loads) {
    if (!std::holds_alternative<model::Driven>(load.history)) continue;
    const double drive = load.force.dot(span.built.model.displacement(shape.data(), load.node)) / load.force.norm();
    amplitude = std::max(amplitude, trial.steady_amplitude(load.force.norm(), drive));
  }
  return trial.damping_ratio(amplitude);
}

void choose_step(const Scene& scene, SpanAtRest& span, const system::Vector& shape, VibrationPlan& plan) {
  using casefile::StepRule;
  const casefile::Integrator& integrator = scene.integrator;
  if (integrator.step == StepRule::automatic) {
    // Half of one percent, or of the bound: the estimate is one of a trial cycle.
    plan.aimed_share = std::min(0.01, integrator.max_numerical_share.value_or(casefile::default_numerical_share)) / 2;
    plan.expected_damping_ratio = expected_damping(scene, span, shape, plan);
    const int steps = solver::steps_for(
        method_of(integrator), {.damping_ratio = *plan.expected_damping_ratio, .share = plan.aimed_share});
    plan.step = 1 / (plan.frequency * steps);
  } else if (integrator.step == StepRule::adaptive) {
    constexpr double least_per_cycle = 20;
    plan.step = 1 / (plan.frequency * least_per_cycle);
  } else {
    plan.step = integrator.step_size.value_or(1 / (plan.frequency * integrator.steps_per_cycle.value_or(200)));
  }
  if (integrator.step != StepRule::adaptive && plan.frequency > 0) {
    plan.numerical_damping_ratio =
        solver::damping_ratio(method_of(integrator), angle_per_step(plan.frequency, plan.step));
  }
}

}  // namespace

solver::IntegratorOptions options_of(const Scene& scene, const VibrationPlan& plan, double end_time) {
  const bool adaptive = scene.integrator.step == casefile::StepRule::adaptive;
  return {.step = plan.step,
          .end_time = end_time,
          .newton_tolerance = scene.integrator.newton_tolerance,
          .relative_error = adaptive ? scene.integrator.rtol : 0,
          .stop = {},
          .drives = plan.drives};
}

VibrationPlan plan_vibration(const Scene& scene, SpanAtRest& span) {
  set_proportional_damping(scene, span);
  std::vector<solver::Mode> modes;
  if (const int count = highest_mode(scene)) {
    modes = solver::transverse_modes(span.system, span.u, static_cast<std::size_t>(count));
  }
  const auto mode = [&](int number) -> const solver::Mode& { return modes[static_cast<std::size_t>(number) - 1]; };
  // Antinode amplitudes are those away from the ends: next to a clamp the crest of a mode is a little higher.
  const auto unit_antinode = [&](const solver::Mode& m) -> system::Vector {
    const double loop = build::loop_length(scene, span.built.tension, m.frequency);
    return m.shape / observe::DeflectionPoints(span.built.model, loop).largest(m.shape.data());
  };

  VibrationPlan plan;
  plan.velocity = system::Vector::Zero(span.u.size());
  plan.drives = find_drives(span, modes);
  for (const model::Drive& drive : plan.drives) plan.frequency = std::max(plan.frequency, drive.frequency);
  if (scene.initial) {
    const solver::Mode& m = mode(scene.initial->velocity_mode);
    plan.velocity = scene.initial->antinode_velocity * unit_antinode(m);
    if (plan.frequency == 0) plan.frequency = m.frequency;
  }
  if (scene.analysis.type == AnalysisType::decay) {
    const casefile::DecayAnalysis& decay = scene.analysis.decay;
    const solver::Mode& m = mode(decay.mode);
    plan.frequency = m.frequency;
    plan.cycles = static_cast<std::size_t>(decay.cycles);
    // From rest in the mode's velocity: a deflected shape let go would be a shock to the sections.
    if (decay.antinode_amplitude) {
      plan.velocity = *decay.antinode_amplitude * 2 * std::numbers::pi * m.frequency * unit_antinode(m);
    }
  } else if (scene.analysis.type == AnalysisType::forced) {
    const casefile::ForcedAnalysis& forced = scene.analysis.forced;
    plan.until_steady = !forced.cycles.has_value();
    plan.cycles = forced.cycles ? static_cast<std::size_t>(*forced.cycles) : most_cycles_until_steady;
  }
  if (plan.frequency == 0 && scene.analysis.type != AnalysisType::transient) {
    refuse(scene.source, "analysis.type", "nothing names a frequency, so there is no cycle to count",
           "give a [[load]] of type \"harmonic-force\", or [initial] velocity_mode");
  }
  const solver::Mode* shaken = modes.empty() ? nullptr : &modes.back();
  if (scene.analysis.type == AnalysisType::decay) shaken = &mode(scene.analysis.decay.mode);
  choose_step(scene, span, shaken ? unit_antinode(*shaken) : system::Vector(), plan);
  return plan;
}

}  // namespace strandyn::study
