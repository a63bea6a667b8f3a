#include "steady_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::study {

using casefile::Scene;
using observe::Cycle;

namespace {

constexpr MeanNames of_a_decay{.self_damping = "self-damping (late in the decay)",
                               .free_span = "self-damping of the free span (late in the decay)",
                               .damping_ratio = "damping ratio (late in the decay)"};
constexpr MeanNames not_steady{.self_damping = "self-damping (not steady)",
                               .free_span = "self-damping of the free span (not steady)",
                               .damping_ratio = "damping ratio (not steady)"};

std::vector<std::pair<std::string, double>> mean_of(const std::vector<Cycle>& cycles, std::size_t last) {
  std::vector<std::pair<std::string, double>> mean;
  for (const std::string& name : results::ColumnReader::of(Cycle{}).names) mean.emplace_back(name, 0.0);
  for (std::size_t i = cycles.size() - last; i < cycles.size(); ++i) {
    const std::vector<double> values = results::ColumnReader::of(cycles[i]).values;
    for (std::size_t k = 0; k < values.size(); ++k) mean[k].second += values[k];
  }
  for (auto& [name, x] : mean) x /= static_cast<double>(last);
  mean.front().second = cycles.back().end_time;
  return mean;
}

/// Of the last cycles, as many as show whether a vibration is steady.
std::vector<analysis::CycleFlow> last_flows(const std::vector<Cycle>& cycles) {
  const std::size_t watched = std::min(cycles.size(), analysis::cycles_that_show_steadiness);
  std::vector<analysis::CycleFlow> flows;
  for (std::size_t i = cycles.size() - watched; i < cycles.size(); ++i) {
    const Cycle& c = cycles[i];
    flows.push_back({.amplitude = c.antinode_amplitude, .in = c.work_in(), .lost = c.dissipated() + c.numerical});
  }
  return flows;
}

}  // namespace

bool is_steady(const std::vector<Cycle>& cycles) {
  return analysis::is_steady(analysis::steadiness(last_flows(cycles)));
}

analysis::SpanNumbers numbers_of(const VibrationPlan& plan, const Scene& scene) {
  return {.frequency = plan.frequency,
          .length = scene.span->total_length(),
          .mass_per_length = *casefile::mass_per_length(scene)};
}

SteadyRow steady_row(const VibrationPlan& plan, const Scene& scene, const std::vector<Cycle>& cycles) {
  std::vector<analysis::CycleLosses> losses;
  for (const Cycle& c : cycles) {
    losses.push_back({.antinode_amplitude = c.antinode_amplitude,
                      .friction = c.friction,
                      .material = c.material,
                      .viscous = c.viscous,
                      .air = c.air,
                      .dampers = c.attached,
                      .numerical = c.numerical});
  }
  const analysis::SteadyState s = analysis::steady_state(losses, numbers_of(plan, scene));
  SteadyRow row{.cycles = s.cycles,
                .frequency = plan.frequency,
                .mean = mean_of(cycles, s.cycles),
                .self_damping = s.self_damping,
                .air = s.air * plan.frequency / scene.span->total_length(),
                .loss_factor = s.loss_factor,
                .damping_ratio = s.damping_ratio,
                .numerical_share = s.numerical_share,
                .is_steady = is_steady(cycles),
                .decays = plan.decays,
                .steadiness = analysis::steadiness(last_flows(cycles)),
                .steps_per_cycle = plan.steps_per_cycle(),
                .predicted = plan.numerical_damping_ratio,
                .expected = plan.expected_damping_ratio};
  double energy = 0, numerical = 0, wind = 0;
  for (std::size_t i = cycles.size() - s.cycles; i < cycles.size(); ++i) {
    energy += cycles[i].kinetic + cycles[i].elastic;
    numerical += cycles[i].numerical;
    wind += cycles[i].wind;
  }
  row.dampers = s.dampers * plan.frequency;
  row.wind = wind / static_cast<double>(s.cycles) * plan.frequency / scene.span->total_length();
  if (energy > 0) row.measured = numerical / (4 * std::numbers::pi * energy);
  if (!row.is_steady) row.names = row.decays ? of_a_decay : not_steady;
  return row;
}

void add_free_span(const span::SpanAtRest& span, const observe::Profile& profile, const Eigen::VectorXcd& motion,
                   double loop_length, SteadyRow& row) {
  row.between = span::free_span_of(span, motion, loop_length);
  if (!row.between) return;
  const std::vector<double> lengths = span::section_lengths(span, *row.between);
  double lost = 0;
  for (std::size_t point = 0; point < lengths.size(); ++point) lost += lengths[point] * profile.self_damping(point);
  row.free_span = lost * row.frequency / row.between->length();
}

void warn_where_not_steady(const SteadyRow& row, Outcome& outcome) {
  if (row.is_steady || row.decays) return;
  std::string why = "nothing is lost";
  if (row.steadiness.work_in_over_lost) {
    why = fmt::format("the work that comes in is {:.4g} times what is lost, the loss drifts by {:.2g} %",
                      *row.steadiness.work_in_over_lost, 100 * row.steadiness.loss_drift);
  }
  outcome.warnings.push_back(fmt::format(
      "not steady: over the last {} cycles {}, and the antinode amplitude drifts by {:.2g} %; their means are no "
      "steady state: give more [analysis] cycles, or until = \"steady\"",
      row.cycles, why, 100 * row.steadiness.amplitude_drift));
}

}  // namespace strandyn::study
