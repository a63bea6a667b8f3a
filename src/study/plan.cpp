#include "plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dampers.hpp"
#include "strandyn/build/wind.hpp"
#include "strandyn/observe/deflection_points.hpp"
#include "strandyn/span/damping.hpp"
#include "strandyn/span/trial_cycles.hpp"

namespace strandyn::study {

using casefile::refuse;
using casefile::Scene;

namespace {

/// A mode that the scene speaks of, and the key that does.
struct NamedMode {
  int number = 0;
  std::string key;
};

std::vector<NamedMode> named_modes(const Scene& scene, const PlanAsk& ask) {
  std::vector<NamedMode> modes;
  const auto add = [&](const std::optional<int>& number, const std::string& key) {
    if (number) modes.push_back({.number = *number, .key = key});
  };
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    add(scene.loads[i].frequency_mode, fmt::format("load[{}].frequency", i));
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    add(scene.motions[i].frequency_mode, fmt::format("motion[{}].frequency", i));
  }
  if (scene.initial) add(scene.initial->velocity_mode, "initial.velocity_mode");
  if (!scene.winds.empty()) add(scene.winds.front().mode, "wind[0].mode");
  add(ask.mode, "analysis.mode");
  return modes;
}

bool has_drive(const Scene& scene) {
  return std::ranges::any_of(scene.loads, &casefile::Load::is_harmonic) ||
         std::ranges::any_of(scene.motions, &casefile::Motion::is_harmonic) || !scene.winds.empty();
}

/// The wind acts from here on; a cycle has its frequency where no load has one. Vortices that are locked to a mode find
/// it swinging with the smallest amplitude of their curve, unless the case says how the span begins.
void let_wind_blow(const Scene& scene, const PlanAsk& ask, span::SpanAtRest& span,
                   const std::vector<solver::Mode>& modes, VibrationPlan& plan) {
  const casefile::WindKeys& keys = scene.winds.front();
  const model::Model& model = span.built.model;
  const std::optional<double> shedding = build::shedding_frequency(scene);
  WindRow row{.model = std::string(name_of(keys.model))};
  double frequency = shedding.value_or(0);
  if (const auto* locked = std::get_if<model::LockedInWind>(&*model.wind)) {
    const solver::Mode mode =
        shedding ? span::mode_near(span, *shedding, ask.stop) : modes[static_cast<std::size_t>(*keys.mode) - 1];
    frequency = mode.frequency;
    plan.shape = span::unit_antinode(span, mode);
    if (!scene.initial) {
      const double velocity = 2 * std::numbers::pi * frequency * locked->wind.curve.lowest * locked->wind.diameter;
      plan.velocity = velocity * plan.shape;
    }
    system::Matrix mass = span.system.make_matrix();
    span.system.mass_matrix(span.u.data(), mass);
    system::Vector momentum = span.system.make_vector();
    mass.multiply(plan.shape.data(), momentum.data());
    const double begins = momentum.dot(plan.velocity) / momentum.dot(plan.shape);
    span.system.set_wind(system::make_locked_in_wind(model, {.frequency = frequency,
                                                             .number = mode.number,
                                                             .shape = plan.shape,
                                                             .momentum = momentum,
                                                             .rest = span.u,
                                                             .velocity = begins}));
    row.mode = static_cast<int>(mode.number);
    row.diameter = locked->wind.diameter;
    row.lowest = locked->wind.curve.lowest;
    row.highest = locked->wind.curve.highest;
  } else {
    span.system.set_wind(system::make_wake_wind(model));
    row.diameter = std::get<model::WakeWind>(*model.wind).wake.diameter;
  }
  row.frequency = shedding.value_or(frequency);
  row.speed = air::wind_speed({.diameter = row.diameter, .strouhal = keys.strouhal}, row.frequency);
  if (plan.frequency == 0) plan.frequency = frequency;
  plan.wind = row;
}

/// What the span asks of its drives, with the frequencies of the modes.
std::vector<model::Drive> find_drives(const span::SpanAtRest& span, const std::vector<solver::Mode>& modes) {
  std::vector<model::Drive> drives;
  for (const build::DriveAsk& ask : span.built.drives) {
    drives.push_back(
        {.frequency = ask.mode ? modes[static_cast<std::size_t>(*ask.mode) - 1].frequency : ask.frequency.value_or(0)});
  }
  return drives;
}

/// [m] of the antinode, by the initial velocity.
double start_amplitude(const VibrationPlan& plan, const span::SpanAtRest& span) {
  const double velocity = observe::DeflectionPoints(span.built.model, 0).largest(plan.velocity.data());
  return velocity / (2 * std::numbers::pi * plan.frequency);
}

/// The amplitude of the start, or where the loads feed what is lost, if that is more. [m]
double steady_amplitude(const VibrationPlan& plan, const span::SpanAtRest& span, span::TrialCycles& trial) {
  double amplitude = start_amplitude(plan, span);
  for (const model::Load& load : span.built.model.loads) {
    if (!std::holds_alternative<model::Driven>(load.history) || load.force.isZero(0)) continue;
    const double drive =
        load.force.dot(span.built.model.displacement(plan.shape.data(), load.node)) / load.force.norm();
    amplitude = std::max(amplitude, trial.steady_amplitude(load.force.norm(), drive));
  }
  return amplitude;
}

/// The lowest physical damping that the run will see: that of its smallest amplitude.
double expected_damping(const VibrationPlan& plan, bool decays, const span::SpanAtRest& span, const Stop& stop) {
  if (plan.shape.size() == 0) return 0;
  span::TrialCycles trial(span, plan.shape, plan.frequency, stop);
  if (!decays) return trial.damping_ratio(steady_amplitude(plan, span, trial));
  const double amplitude = start_amplitude(plan, span);
  const double late = trial.damping_ratio(trial.decayed_amplitude(amplitude, plan.cycles));
  return late > 0 ? late : trial.damping_ratio(amplitude);
}

void choose_step(const Scene& scene, const build::Integration& integration, const PlanAsk& ask,
                 const span::SpanAtRest& span, VibrationPlan& plan) {
  if (integration.chooses_steps()) {
    // Half of one percent, or of the bound: the estimate is one of a trial cycle.
    const double bound = scene.integrator.max_numerical_share.value_or(casefile::default_numerical_share);
    plan.aimed_share = std::min(0.01, bound) / 2;
    plan.expected_damping_ratio = expected_damping(plan, ask.mode.has_value(), span, ask.stop);
    const int steps = solver::steps_for(integration.method(),
                                        {.damping_ratio = *plan.expected_damping_ratio, .share = plan.aimed_share});
    plan.step = 1 / (plan.frequency * steps);
  } else if (integration.controls_error()) {
    constexpr double least_per_cycle = 20;
    plan.step = 1 / (plan.frequency * least_per_cycle);
  } else {
    plan.step = integration.step_at(plan.frequency);
  }
  if (!integration.controls_error() && plan.frequency > 0) {
    plan.numerical_damping_ratio = integration.damping_ratio(plan.frequency, plan.step);
  }
}

}  // namespace

PlanRow row_of(const VibrationPlan& plan) {
  PlanRow row{.step = plan.step, .numerical = plan.numerical_damping_ratio, .expected = plan.expected_damping_ratio};
  if (plan.frequency > 0) {
    row.frequency = plan.frequency;
    row.steps_per_cycle = plan.steps_per_cycle();
  }
  if (plan.expected_damping_ratio) row.aimed_share = plan.aimed_share;
  return row;
}

std::string words_of(const VibrationPlan& plan, const build::Integration& integration) {
  if (plan.frequency == 0) return fmt::format("steps of {:.4g} s", plan.step);
  std::string text = fmt::format("{:.5g} Hz, ", plan.frequency);
  if (integration.controls_error()) {
    return text + fmt::format(
                      "steps by IDA's error control at {:.3g}, at least {:.0f} per cycle: their damping shows "
                      "in the ledger only",
                      integration.relative_error(), plan.steps_per_cycle());
  }
  text += fmt::format("{:.5g} steps per cycle", plan.steps_per_cycle());
  if (plan.expected_damping_ratio) {
    text += fmt::format(", chosen for a numerical share of {:.2g} % at an expected damping ratio of {:.3g}",
                        100 * plan.aimed_share, *plan.expected_damping_ratio);
  }
  return text + fmt::format(": the integrator's own damping ratio will be {:.3g}", *plan.numerical_damping_ratio);
}

void check_plan(const Scene& scene, const build::BuiltSpan& span, const PlanAsk& ask) {
  const std::vector<NamedMode> modes = named_modes(scene, ask);
  for (const NamedMode& mode : modes) build::require_modes(scene, span, mode.number, mode.key);
  if (scene.air && !scene.air->frequency && !has_drive(scene) && !scene.initial && !ask.mode) {
    refuse(scene.source, "air.frequency_Hz", "is missing, and nothing names a frequency for the force of the air",
           "give the frequency in hertz at which the span swings");
  }
  if (!scene.dampers.empty() && !has_drive(scene) && !scene.initial && !ask.mode) {
    refuse(scene.source, "damper", "its messenger loses at one frequency, and nothing names one",
           "give a harmonic load, [[wind]], or [initial] velocity_mode");
  }
  if (scene.output && scene.output->per_cycle && !has_drive(scene) && !scene.initial && !ask.mode) {
    refuse(scene.source, "output.fields_per_cycle", "counts cycles, and nothing names a frequency",
           "give fields_every_s, in seconds");
  }
  if (ask.counts_cycles && !has_drive(scene) && !scene.initial && !ask.mode) {
    refuse(scene.source, "analysis.type", "nothing names a frequency, so there is no cycle to count",
           "give a [[load]] of type \"harmonic-force\", or [initial] velocity_mode");
  }
}

VibrationPlan plan_vibration(const Scene& scene, const build::Integration& integration, const PlanAsk& ask,
                             span::SpanAtRest& span) {
  span::set_proportional_damping(span);
  int highest = 0;
  for (const NamedMode& mode : named_modes(scene, ask)) highest = std::max(highest, mode.number);
  const std::vector<solver::Mode> modes = span::modes_across(span, highest, ask.stop);
  const auto mode = [&](int number) -> const solver::Mode& { return modes[static_cast<std::size_t>(number) - 1]; };

  VibrationPlan plan{.cycles = ask.cycles, .until_steady = ask.until_steady, .decays = ask.mode.has_value()};
  plan.velocity = system::Vector::Zero(span.u.size());
  plan.drives = find_drives(span, modes);
  for (const model::Drive& drive : plan.drives) plan.frequency = std::max(plan.frequency, drive.frequency);
  if (scene.initial) {
    const solver::Mode& m = mode(scene.initial->velocity_mode);
    plan.velocity = scene.initial->antinode_velocity * span::unit_antinode(span, m);
    if (plan.frequency == 0) plan.frequency = m.frequency;
  }
  if (ask.mode) {
    const solver::Mode& m = mode(*ask.mode);
    plan.frequency = m.frequency;
    // From rest in the mode's velocity: a deflected shape let go would be a shock to the sections.
    if (ask.antinode_amplitude) {
      plan.velocity = *ask.antinode_amplitude * 2 * std::numbers::pi * m.frequency * span::unit_antinode(span, m);
    }
  }
  if (scene.air) {
    const double swing = scene.air->frequency.value_or(plan.frequency);
    if (swing > 0) span.system.set_swing(swing);
  }
  if (!modes.empty()) plan.shape = span::unit_antinode(span, ask.mode ? mode(*ask.mode) : modes.back());
  if (!scene.winds.empty()) let_wind_blow(scene, ask, span, modes, plan);
  hang_dampers(scene, plan.frequency, span);
  choose_step(scene, integration, ask, span, plan);
  return plan;
}

double expected_amplitude(const VibrationPlan& plan, const span::SpanAtRest& span) {
  if (plan.shape.size() == 0 || plan.frequency == 0) return 0;
  span::TrialCycles trial(span, plan.shape, plan.frequency);
  // From rest a force that meets no loss gives pi F phi/(m omega^2) a cycle.
  const double modal_mass = 2 * span.system.kinetic_energy(span.u.data(), plan.shape.data());
  const double omega = 2 * std::numbers::pi * plan.frequency;
  double growth = 0;
  for (const model::Load& load : span.built.model.loads) {
    if (!std::holds_alternative<model::Driven>(load.history)) continue;
    growth += std::abs(load.force.dot(span.built.model.displacement(plan.shape.data(), load.node)));
  }
  growth *= std::numbers::pi / (modal_mass * omega * omega);
  return std::min(steady_amplitude(plan, span, trial),
                  start_amplitude(plan, span) + static_cast<double>(plan.cycles) * growth);
}

}  // namespace strandyn::study
