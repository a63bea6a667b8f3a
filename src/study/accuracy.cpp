#include "accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "entries.hpp"
#include "strandyn/analysis/richardson.hpp"
#include "strandyn/build/section_law.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

/// Of a decay: all of a short one. Errors grow from cycle to cycle, so a long one is not known by its first.
int cycles_to_run(int cycles) {
  constexpr int few = 6;
  return std::min(cycles, std::max(few, cycles / 4));
}

/// Friction and damping of the metal, of each cycle of a decay or of the mean of the steady ones.
std::vector<double> dissipation_of(const Scene& scene, const results::Value& summary) {
  const auto add = [](const results::Value& cycle, std::vector<double>& all) {
    const std::optional<double> friction = casefile::number_at("friction_dissipation_J", cycle);
    if (friction) all.push_back(*friction + casefile::number_at("material_dissipation_J", cycle).value_or(0));
  };
  std::vector<double> all;
  const bool decays = scene.is<casefile::DecayAnalysis>();
  const results::Value* const rows = summary.find(decays ? "cycles" : "steady");
  if (!rows) return all;
  if (!decays) {
    add(*rows, all);
    return all;
  }
  for (const results::Value& cycle : rows->entries()) add(cycle, all);
  return all;
}

/// A decay or a forced vibration.
Lost run_analysis(const Scene& scene, const Hooks& hooks, Cost& cost) {
  Outcome outcome;
  prepare(scene)->run(hooks, outcome);
  Lost lost{.interrupted = outcome.exit_code == ExitCode::interrupted};
  if (!outcome.ended_early) lost.dissipation = dissipation_of(scene, outcome.summary);
  lost.energy = casefile::number_at("cycles[max].kinetic_J", outcome.summary).value_or(0);
  cost.add(outcome.cost);
  return lost;
}

}  // namespace

Scene with_setting(Scene scene, const Setting& setting) {
  scene.span->elements = setting.elements;
  scene.integrator.step = casefile::StepRule::fixed;
  scene.integrator.step_size.reset();
  scene.integrator.steps_per_cycle = setting.steps_per_cycle;
  scene.section.points = setting.points;
  return scene;
}

Stretch::Stretch(const Scene& scene, const Hooks& hooks, LossRun run)
    : scene_(scene),
      hooks_(hooks),
      run_(run ? std::move(run) : run_analysis),
      slips_(build::slips_by_points(scene.section.law)),
      resonates_(!scene.is<casefile::DecayAnalysis>()) {
  if (auto* decay = std::get_if<casefile::DecayAnalysis>(&scene_.analysis)) {
    decay->cycles = cycles_to_run(decay->cycles);
  }
}

const Lost& Stretch::run(const Setting& setting) {
  const auto [at, is_new] = results_.try_emplace(setting);
  Lost& result = at->second;
  if (!is_new) return result;
  const Scene scene = with_setting(scene_, setting);
  const std::string words = fmt::format("error estimate: {} elements, {} steps a cycle, {} points", setting.elements,
                                        setting.steps_per_cycle, setting.points);
  const Hooks inner{.stop = hooks_.stop, .progress = [&](double, std::string_view) {
                      if (hooks_.progress) hooks_.progress(0, words);
                    }};
  try {
    result = run_(scene, inner, cost_);
  } catch (const Interrupted&) {
    result.interrupted = true;
  } catch (const ComputationError&) {  // too coarse to be integrated
  } catch (const InputError&) {        // too coarse for its modes
  }
  return result;
}

/// [J] infinite where one of them has failed.
double Stretch::apart(const Lost& a, const Lost& b) {
  if (a.dissipation.empty() || a.dissipation.size() != b.dissipation.size()) return INFINITY;
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < a.dissipation.size(); ++i) {
    const double difference = a.dissipation[i] - b.dissipation[i];
    sum += difference;
    squares += difference * difference;
  }
  return std::max(std::abs(sum), std::sqrt(squares));
}

std::optional<ErrorEstimate> Stretch::estimate(const Setting& setting) {
  // Near a resonance a step four times as long detunes too much to judge a mesh by.
  constexpr int fewest_steps = 40;
  const bool many_steps = setting.steps_per_cycle >= fewest_steps;
  const int slow = many_steps && !resonates_ ? 4 : 2;
  constexpr analysis::Order in_time{.least = 2, .highest = 2, .expected = 2};
  constexpr analysis::Order in_space{.least = 1.5, .highest = 4, .expected = 2};
  constexpr double by_points_alone = 1.5;
  const auto with = [&](int elements_over, int steps_over, int points) -> const Lost& {
    return run({.elements = std::max(setting.elements / elements_over, 1),
                .steps_per_cycle = std::max(setting.steps_per_cycle / steps_over, 4),
                .points = points});
  };
  const int p = setting.points;
  const std::optional<int> finer = slips_ ? build::finer_points(p) : std::nullopt;
  const std::array<const Lost*, 3> by_time = {&with(2, 1, p), &with(2, 2, p), &with(2, many_steps ? 4 : 2, p)};
  const std::array<const Lost*, 3> by_mesh = {&with(1, slow, p), &with(2, slow, p), &with(4, slow, p)};
  const std::array<const Lost*, 2> by_points = {&with(4, slow, p), &with(4, slow, finer.value_or(p))};
  for (const auto& [at, result] : results_) {
    if (result.interrupted) return std::nullopt;
  }
  const Lost& best = *by_mesh[0];
  double dissipation = 0;
  for (const double of_cycle : best.dissipation) dissipation += std::abs(of_cycle);
  const double size = std::max(dissipation, 1e-4 * best.energy);
  ErrorEstimate estimate;
  estimate.section_evaluations = static_cast<double>(cost_.section_evaluations);
  if (!(size > 0) && !best.dissipation.empty()) return estimate;  // nothing moves
  const std::optional<double> before_in_time =
      many_steps ? std::optional(apart(*by_time[1], *by_time[2])) : std::nullopt;
  estimate.time = analysis::richardson(apart(*by_time[0], *by_time[1]), before_in_time, in_time) / size;
  estimate.mesh =
      analysis::richardson(apart(*by_mesh[0], *by_mesh[1]), apart(*by_mesh[1], *by_mesh[2]), in_space) / size;
  if (finer) estimate.points = by_points_alone * apart(*by_points[0], *by_points[1]) / size;
  return estimate;
}

}  // namespace strandyn::study
