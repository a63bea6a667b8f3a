#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  if (scene.initial) highest = std::max(highest, scene.initial->velocity_mode);
  if (scene.analysis.type == AnalysisType::decay) highest = std::max(highest, scene.analysis.decay.mode);
  return highest;
}

/// Sets the loads' frequencies and returns the highest of them [Hz].
double load_frequencies(const Scene& scene, SpanAtRest& span, const std::vector<solver::Mode>& modes) {
  double highest = 0;
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const casefile::Load& load = scene.loads[i];
    if (load.type != casefile::LoadType::harmonic_force) continue;
    const double frequency =
        load.frequency_mode ? modes[static_cast<std::size_t>(*load.frequency_mode) - 1].frequency : *load.frequency;
    casefile::set_load_frequency(span.built, i, frequency);
    highest = std::max(highest, frequency);
  }
  return highest;
}

}  // namespace

double VibrationPlan::numerical_damping_ratio() const {
  return std::pow(2 * std::numbers::pi * frequency * step, 3) / 4;
}

VibrationPlan plan_vibration(const Scene& scene, SpanAtRest& span) {
  std::vector<solver::Mode> modes;
  if (const int count = highest_mode(scene)) {
    modes = solver::transverse_modes(span.system, span.u, static_cast<std::size_t>(count));
  }
  const auto mode = [&](int number) -> const solver::Mode& { return modes[static_cast<std::size_t>(number) - 1]; };
  // Antinode amplitudes are those away from the ends: next to a clamp the crest of a mode is a little higher.
  const auto unit_antinode = [&](const solver::Mode& m) -> system::Vector {
    const double loop = casefile::loop_length(scene, span.built.tension, m.frequency);
    return m.shape / observe::DeflectionPoints(span.built.model, loop).largest(m.shape.data());
  };

  VibrationPlan plan;
  plan.velocity = system::Vector::Zero(span.u.size());
  plan.frequency = load_frequencies(scene, span, modes);
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
  } else {
    const casefile::ForcedAnalysis& forced = scene.analysis.forced;
    plan.until_steady = !forced.cycles.has_value();
    plan.cycles = forced.cycles ? static_cast<std::size_t>(*forced.cycles) : most_cycles_until_steady;
  }
  if (plan.frequency == 0) {
    refuse(scene.source, "analysis.type", "nothing names a frequency, so there is no cycle to count",
           "give a [[load]] of type \"harmonic-force\", or [initial] velocity_mode");
  }
  const casefile::Integrator& integrator = scene.integrator;
  plan.step = integrator.step_size.value_or(1 / (plan.frequency * integrator.steps_per_cycle.value_or(200)));
  return plan;
}

}  // namespace strandyn::study
