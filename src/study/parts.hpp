#pragma once
/// \file The analyses that `run_case` chooses from. Each fills its part of the result.

#include <optional>

#include "strandyn/casefile/build.hpp"
#include "strandyn/solver/modes.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::study {

void run_section(const casefile::Scene& scene, CaseResult& result);
void run_axial_torsion(const casefile::Scene& scene, CaseResult& result);
void run_static(const casefile::Scene& scene, CaseResult& result);
void run_modes(const casefile::Scene& scene, CaseResult& result);
void run_vibration(const casefile::Scene& scene, const Hooks& hooks, CaseResult& result);

/// A span at rest in its static state, ready to be set in motion.
struct SpanAtRest {
  explicit SpanAtRest(const casefile::Scene& scene);

  casefile::BuiltSpan built;
  system::System system;
  system::Vector u;
};

/// How a vibration is to be integrated.
struct VibrationPlan {
  double frequency = 0;  ///< [Hz] that a cycle refers to
  std::size_t cycles = 0;
  bool until_steady = false;  ///< then `cycles` is the most that will be run
  double step = 0;            ///< [s]
  system::Vector velocity;    ///< initial

  double steps_per_cycle() const { return 1 / (frequency * step); }
  /// (omega h)^3/4: what the second-order BDF formula takes from a mode of this frequency.
  double numerical_damping_ratio() const;
};

/// Finds the modes that the scene speaks of, gives the loads their frequencies, and decides the step.
VibrationPlan plan_vibration(const casefile::Scene& scene, SpanAtRest& span);

/// `section` of summary.json, also of what `describe` tells.
nlohmann::ordered_json section_json(const casefile::SectionNumbers& numbers);

/// cost.* of summary.json from a system's counters.
void add_effort(const system::System& system, nlohmann::ordered_json& cost);

}  // namespace strandyn::study
