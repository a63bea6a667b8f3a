#pragma once
/// \file The mean of the last cycles of a vibration, what it says of the damping, and whether it is a steady state.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plan.hpp"
#include "strandyn/analysis/steady.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/span/free_span.hpp"

namespace strandyn::study {

/// What a mean of cycles may be called.
struct MeanNames {
  const char* self_damping = "self-damping";
  const char* free_span = "self-damping of the free span";
  const char* damping_ratio = "damping ratio";
};

/// The mean of the last cycles and what it says of the damping.
struct SteadyRow {
  MeanNames names = {};
  std::size_t cycles = 0;
  double frequency = 0;
  std::vector<std::pair<std::string, double>> mean;  ///< of the members of a cycle
  double self_damping = 0, air = 0, wind = 0, dampers = 0, loss_factor = 0, damping_ratio = 0;
  std::optional<double> free_span{};
  std::optional<span::Piece> between{};  ///< the nodes of the free span
  std::optional<double> numerical_share{};
  bool is_steady = false, decays = false;
  analysis::Steadiness steadiness{};
  double steps_per_cycle = 0;
  std::optional<double> predicted{}, measured{}, expected{};
};
template <class V>
void members(V& v, SteadyRow& s) {
  v.value("cycles", s.cycles, {.what = "over how many the means were taken"});
  v.value("frequency_Hz", s.frequency, {.what = "that a cycle refers to"});
  for (auto& [key, x] : s.mean) {
    const bool amplitude = key == "antinode_amplitude_m";
    const bool friction = key == "friction_dissipation_J";
    v.value(key.c_str(), x,
            {.what = "mean of the cycles' member; the time is that of the end",
             .shown = amplitude  ? "antinode amplitude"
                      : friction ? "friction per cycle"
                                 : nullptr});
  }
  v.value("self_damping_W_per_m", s.self_damping,
          {.what = "friction, material and viscous damping over the length", .shown = s.names.self_damping});
  std::optional<double> from, to;
  if (s.between) from = s.between->from, to = s.between->to;
  v.value(
      "self_damping_free_span_W_per_m", s.free_span,
      {.what = "friction and material damping between the first and the last inner node, over the length between them",
       .shown = s.names.free_span});
  v.value("free_span_from_m", from, {.what = "the first inner node", .shown = "free span from"});
  v.value("free_span_to_m", to, {.what = "the last inner node", .shown = "free span to"});
  v.value("air_W_per_m", s.air, {.what = "still air over the length, not in the self-damping"});
  v.value("dampers_W", s.dampers, {.what = "what all Stockbridge dampers lose, not in the self-damping"});
  v.value("wind_W_per_m", s.wind, {.what = "what the wind gives, over the length"});
  v.value("loss_factor", s.loss_factor, {.what = "twice the damping ratio"});
  v.value("damping_ratio", s.damping_ratio, {.what = "of the antinode's velocity", .shown = s.names.damping_ratio});
  v.value("numerical_share", s.numerical_share,
          {.what = "|numerical| over all physical losses", .shown = "numerical share"});
  v.value("is_steady", s.is_steady,
          {.what = "what comes in is what is lost, and neither amplitude nor loss drifts, over the last 20 cycles"});
  v.value(
      "work_in_over_lost", s.steadiness.work_in_over_lost,
      {.what = "what loads and wind do over all that is lost, numerical part included, in these cycles; 1 where steady",
       .shown = s.decays ? nullptr : "work in over lost"});
  v.value("amplitude_drift", s.steadiness.amplitude_drift,
          {.what = "of a straight line through the antinode amplitudes of these cycles, of their mean"});
  v.value("loss_drift", s.steadiness.loss_drift, {.what = "the same of what is lost"});
  v.value("steps_per_cycle", s.steps_per_cycle, {.what = "of the integration"});
  v.value("predicted_numerical_damping_ratio", s.predicted, {.what = "by the formula of the integrator"});
  v.value("measured_numerical_damping_ratio", s.measured, {.what = "by the ledger"});
  v.value("expected_damping_ratio", s.expected, {.what = "for which the step was chosen"});
}

bool is_steady(const std::vector<observe::Cycle>& cycles);
analysis::SpanNumbers numbers_of(const VibrationPlan& plan, const casefile::Scene& scene);
SteadyRow steady_row(const VibrationPlan& plan, const casefile::Scene& scene,
                     const std::vector<observe::Cycle>& cycles);
/// The loss of the free span, where the vibration has one.
void add_free_span(const span::SpanAtRest& span, const observe::Profile& profile, const Eigen::VectorXcd& motion,
                   double loop_length, SteadyRow& row);
/// A mean over cycles that are on their way is no steady state.
void warn_where_not_steady(const SteadyRow& row, Outcome& outcome);

}  // namespace strandyn::study
