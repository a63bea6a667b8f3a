#pragma once
/// \file The analyses that `run_case` chooses from. Each fills its part of the result.

#include <optional>

#include "strandyn/build/span.hpp"
#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::study {

void run_section(const casefile::Scene& scene, CaseResult& result);
void run_axial_torsion(const casefile::Scene& scene, CaseResult& result);
void run_static(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);
void run_modes(const casefile::Scene& scene, CaseResult& result);
void run_vibration(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);
void run_transient(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);
void run_sweep(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);
void run_self_damping(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);

/// A span at rest in its static state, ready to be set in motion.
struct SpanAtRest {
  explicit SpanAtRest(const casefile::Scene& scene);
  /// Brings the loads that do not change to their full size: what a vibration is about.
  void apply_static_loads();

  build::BuiltSpan built;
  system::System system;
  system::Vector u;
};

/// `rest` of summary.json: how a hanging span hangs.
void add_rest(const SpanAtRest& span, CaseResult& result);
/// shape.csv, `right_end_m` and `reactions` of a static state under `load_factor` of its loads.
void add_shape(const SpanAtRest& span, double load_factor, CaseResult& result);

/// How a vibration is to be integrated.
struct VibrationPlan {
  double frequency = 0;  ///< [Hz] that a cycle refers to; 0 where a transient names none
  std::size_t cycles = 0;
  bool until_steady = false;  ///< then `cycles` is the most that will be run
  double step = 0;            ///< [s] its bound, where the integrator chooses steps by their error
  system::Vector velocity;    ///< initial
  std::vector<model::Drive> drives;
  /// [-] what the integrator will take from a mode of this frequency; empty where it chooses its steps itself.
  std::optional<double> numerical_damping_ratio;
  /// Where the program has chosen the step (`auto`): the physical damping it expects, and the share it aims at.
  std::optional<double> expected_damping_ratio;
  double aimed_share = 0;

  double steps_per_cycle() const { return 1 / (frequency * step); }
};

/// Options of an integration by this plan.
solver::IntegratorOptions options_of(const casefile::Scene& scene, const VibrationPlan& plan, double end_time);

/// Gives the system the scene's modal and Rayleigh damping, about its state of rest.
void set_proportional_damping(const casefile::Scene& scene, SpanAtRest& span);

/// `plan` of summary.json: step, frequency, and the damping that is predicted of them.
nlohmann::ordered_json plan_json(const VibrationPlan& plan);
/// Keeps the plan in the summary and tells it in words, before the run.
void announce(const casefile::Scene& scene, const VibrationPlan& plan, const Hooks& hooks, CaseResult& result);

/// Finds the modes that the scene speaks of, finds the frequencies of the drives, and decides the step.
VibrationPlan plan_vibration(const casefile::Scene& scene, SpanAtRest& span);

/// `section` of summary.json, also of what `describe` tells.
nlohmann::ordered_json section_json(const build::SectionNumbers& numbers);

/// cost.* of summary.json from an integration, with a warning of steps that fell back to order 1.
void add_integration(const solver::IntegratorSummary& run, const system::System& system, CaseResult& result);

/// cost.* of summary.json from a system's counters.
void add_effort(const system::System& system, nlohmann::ordered_json& cost);

}  // namespace strandyn::study
