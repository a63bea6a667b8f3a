#pragma once
/// \file How a vibration is to be integrated: which modes the case speaks of, the frequencies of its loads, its initial
/// velocity, its step.

#include <optional>

#include "strandyn/build/method.hpp"
#include "strandyn/span/modes.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// What an analysis asks of the plan beside the case's loads and [initial].
struct PlanAsk {
  bool counts_cycles = true;                   ///< a transient need not have any
  std::optional<int> mode{};                   ///< whose frequency a cycle has
  std::optional<double> antinode_amplitude{};  ///< [m] with which that mode starts
  std::size_t cycles = 0;                      ///< the most that will be run
  bool until_steady = false;
  Stop stop = {};  ///< asked while modes and trial cycles are computed
};

/// `wind` of summary.json: what blows.
struct WindRow {
  std::string model{};
  double frequency = 0, speed = 0, diameter = 0;
  std::optional<int> mode{};
  std::optional<double> lowest{}, highest{};  ///< [-] A/D, the range of the curve; not told
};
template <class V>
void members(V& v, WindRow& w) {
  v.value("model", w.model, {.what = "power-curve or wake-oscillator"});
  v.value("frequency_Hz", w.frequency, {.what = "at which vortices are shed, at the start"});
  v.value("wind_speed_m_per_s", w.speed, {.what = "that sheds them at this frequency"});
  v.value("diameter_m", w.diameter, {.what = "that the wind meets"});
  v.value("mode", w.mode, {.what = "to which they are locked"});
}

struct VibrationPlan {
  double frequency = 0;  ///< [Hz] that a cycle refers to; 0 where a transient names none
  std::size_t cycles = 0;
  bool until_steady = false;  ///< then `cycles` is the most that will be run
  bool decays = false;        ///< a mode is let go
  double step = 0;            ///< [s] its bound, where the integrator chooses steps by their error
  system::Vector velocity{};  ///< initial
  std::vector<model::Drive> drives{};
  system::Vector shape{};  ///< of the mode that is shaken, at an antinode of 1 m; empty where none is named
  /// [-] what the integrator will take from a mode of this frequency; empty where it chooses its steps itself.
  std::optional<double> numerical_damping_ratio{};
  /// Where the program has chosen the step (`auto`): the physical damping it expects, and the share it aims at.
  std::optional<double> expected_damping_ratio{};
  double aimed_share = 0;
  std::optional<WindRow> wind{};

  double steps_per_cycle() const { return 1 / (frequency * step); }
};

/// `plan` of summary.json.
struct PlanRow {
  double step = 0;
  std::optional<double> frequency{}, steps_per_cycle{}, numerical{}, expected{}, aimed_share{};
};
template <class V>
void members(V& v, PlanRow& p) {
  v.value("step_s", p.step, {.what = "the time step, or its bound"});
  v.value("frequency_Hz", p.frequency, {.what = "that a cycle refers to"});
  v.value("steps_per_cycle", p.steps_per_cycle, {.what = "of the integration"});
  v.value("predicted_numerical_damping_ratio", p.numerical, {.what = "what the integrator will take from that mode"});
  v.value("expected_damping_ratio", p.expected, {.what = "the physical damping for which the step was chosen"});
  v.value("aimed_numerical_share", p.aimed_share, {.what = "the numerical share that was aimed at"});
}
PlanRow row_of(const VibrationPlan& plan);
/// "24.4 Hz, 220 steps per cycle, chosen for ...: the integrator's own damping ratio will be 5.8e-06"
std::string words_of(const VibrationPlan& plan, const build::Integration& integration);

/// Refuses modes that the mesh does not have, and a vibration of which nothing tells the frequency.
void check_plan(const casefile::Scene& scene, const build::BuiltSpan& span, const PlanAsk& ask);
/// Finds the modes that the scene speaks of, gives the loads their frequencies, and decides the step.
VibrationPlan plan_vibration(const casefile::Scene& scene, const build::Integration& integration, const PlanAsk& ask,
                             span::SpanAtRest& span);
/// The amplitude that the vibration will have, largest: the start's, or that at which the loads feed what is lost. [m]
double expected_amplitude(const VibrationPlan& plan, const span::SpanAtRest& span);

}  // namespace strandyn::study
