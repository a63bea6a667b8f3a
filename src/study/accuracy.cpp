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

int part_of(int number, double parts, int least) {
  return std::max(static_cast<int>(std::lround(number / parts)), least);
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

Stretch::Stretch(const Scene& scene, const Setting& first, double mesh_ratio, const Hooks& hooks, LossRun run)
    : scene_(scene),
      first_(first),
      mesh_ratio_(mesh_ratio),
      hooks_(hooks),
      run_(run ? std::move(run) : run_analysis),
      slips_(build::slips_by_points(scene.section.law)),
      resonates_(!scene.is<casefile::DecayAnalysis>()) {
  if (auto* decay = std::get_if<casefile::DecayAnalysis>(&scene_.analysis)) {
    const int all = decay->cycles;
    decay->cycles = cycles_to_run(all);
    share_of_cycles_ = static_cast<double>(decay->cycles) / all;
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

/// [J] by the steps of the search so far, on half the mesh that it began with; on a finer one where that is too far
/// from the mesh of the run, since its errors of time are then others.
double Stretch::by_time(const Setting& setting) {
  if (steps_.empty()) {
    steps_ = {part_of(first_.steps_per_cycle, 2, 4)};
    if (has_many_steps()) steps_.insert(part_of(first_.steps_per_cycle, 4, 4));
  }
  const auto now = steps_.insert(setting.steps_per_cycle).first;
  if (now == steps_.begin()) return INFINITY;
  Setting own = first_;
  own.elements = std::max(part_of(first_.elements, 2, 1), part_of(setting.elements, 4, 1));
  const auto with = [&](int steps) -> const Lost& {
    own.steps_per_cycle = steps;
    return run(own);
  };
  if (with(*now).dissipation.empty()) own.elements = first_.elements;
  const int before = *std::prev(now);
  const double ratio = static_cast<double>(*now) / before;
  analysis::Order second{.least = 2, .highest = 2, .expected = 2, .ratio = ratio, .ratio_before = ratio};
  std::optional<double> earlier;
  if (std::prev(now) != steps_.begin()) {
    const int first = *std::prev(now, 2);
    second.ratio_before = static_cast<double>(before) / first;
    earlier = apart(with(before), with(first));
  }
  return analysis::richardson(apart(with(*now), with(before)), earlier, second);
}

double Stretch::share_of_first() const {
  const double m = mesh_ratio_, slow = 1.0 / times_slower();
  const double time = 0.5 * (has_many_steps() ? 1.75 : 1.5);
  const double points = slips_ ? slow / (m * m) : 0;
  return share_of_cycles_ * (time + slow * (1 + 1 / m + 1 / (m * m)) + points);
}

std::optional<ErrorEstimate> Stretch::estimate(const Setting& setting) {
  constexpr double by_points_alone = 1.5;
  const int slow = part_of(first_.steps_per_cycle, times_slower(), 4);
  const auto with = [&](double coarser, int points) -> const Lost& {
    return run({.elements = part_of(setting.elements, coarser, 1), .steps_per_cycle = slow, .points = points});
  };
  const double m = mesh_ratio_;
  const std::array<const Lost*, 3> by_mesh = {&with(1, first_.points), &with(m, first_.points),
                                              &with(m * m, first_.points)};
  const double time = by_time(setting);
  const std::optional<int> finer = slips_ ? build::finer_points(setting.points) : std::nullopt;
  const double points = finer ? apart(with(m * m, setting.points), with(m * m, *finer)) : 0;
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
  const analysis::Order in_space{.least = 1.5, .highest = 4, .expected = 2, .ratio = m, .ratio_before = m};
  estimate.time = time / size;
  estimate.mesh =
      analysis::richardson(apart(*by_mesh[0], *by_mesh[1]), apart(*by_mesh[1], *by_mesh[2]), in_space) / size;
  if (finer) estimate.points = by_points_alone * points / size;
  return estimate;
}

}  // namespace strandyn::study
