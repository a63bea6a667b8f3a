#include "periodic_accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "strandyn/analysis/richardson.hpp"

namespace strandyn::self_damping {

using casefile::Scene;

namespace {

constexpr int most_rounds = 8;
constexpr int most_finer = 4;  ///< times the elements and the harmonics begun with
constexpr int most_harmonics = 31, most_samples = 1024;

int fewest_samples(int harmonics) {
  return 4 * harmonics + 4;
}

/// Half as many or one more, of an odd number: even ones hardly count. Of one or two harmonics, two more.
int other_harmonics(int harmonics) {
  return harmonics >= 3 ? (harmonics / 2) | 1 : harmonics + 2;
}

/// The knobs that the case leaves open.
struct Free {
  explicit Free(const Scene& scene)
      : elements(!scene.span->elements),
        harmonics(!scene.source.find("analysis.periodic.harmonics")),
        samples(!scene.source.find("analysis.periodic.samples")),
        points(!scene.source.find("section.points") && build::slips_by_points(scene.section.law)) {}
  bool elements, harmonics, samples, points;
};

/// Runs of one point, each setting once.
class Runs {
 public:
  Runs(const Scene& scene, const Point& point, const Watch& watch)
      : scene_(build::scene_of_point(scene, point.ask())),
        point_(point),
        watch_(watch),
        slips_(build::slips_by_points(scene.section.law)) {}

  PeriodicRun& run(const PeriodicSetting& setting);
  PointError error_of(const PeriodicSetting& setting, double mass);
  const section::Effort& effort() const { return effort_; }
  PeriodicRun take(const PeriodicSetting& setting) { return std::move(run(setting)); }

 private:
  void solve(const PeriodicSetting& setting, PeriodicRun& run) const;
  /// A run that is there, as near as can be: on the same mesh, else on the finest.
  const PeriodicRun* nearest(const PeriodicSetting& setting) const {
    const PeriodicRun* best = nullptr;
    int elements = 0;
    for (const auto& [other, run] : runs_) {
      if (!run.converged() || (best && elements == setting.elements)) continue;
      if (best && other.elements < elements && other.elements != setting.elements) continue;
      best = &run;
      elements = other.elements;
    }
    return best;
  }
  /// [W/m] infinite where one of them has failed.
  static double apart(const PeriodicRun& a, const PeriodicRun& b) {
    return a.converged() && b.converged() ? std::abs(a.power - b.power) : INFINITY;
  }

  Scene scene_;
  const Point& point_;
  const Watch& watch_;
  bool slips_;
  std::map<PeriodicSetting, PeriodicRun> runs_;
  section::Effort effort_;
};

PeriodicRun& Runs::run(const PeriodicSetting& setting) {
  const auto there = runs_.find(setting);
  if (there != runs_.end()) return there->second;
  if (watch_.tell) {
    watch_.tell(fmt::format("{} elements, {} harmonics, {} samples, {} points", setting.elements, setting.harmonics,
                            setting.samples, setting.points));
  }
  PeriodicRun run;
  try {
    solve(setting, run);
  } catch (const ComputationError& error) {  // too coarse for its modes, like the next
    run.found.solution.failure = error.what();
  } catch (const InputError& error) {
    run.found.solution.failure = error.what();
  }
  effort_ += run.found.effort;
  return runs_.emplace(setting, std::move(run)).first->second;
}

void Runs::solve(const PeriodicSetting& setting, PeriodicRun& run) const {
  Scene scene = scene_;
  scene.span->elements = setting.elements;
  scene.section.points = setting.points;
  build::BuiltSpan built = build::build_span(scene);
  const build::Shaker shaker = build::find_shaker(scene, built);
  run.shaken = std::make_unique<span::ShakenSpan>(
      std::move(built), shaker, point_.frequency,
      span::ResponseOptions{.harmonics = setting.harmonics, .samples = setting.samples, .stop = watch_.stop});
  const PeriodicRun* start = nearest(setting);
  run.found = start ? run.shaken->resonance(point_.antinode_amplitude, *start->shaken, start->found.solution.state)
                    : run.shaken->resonance(point_.antinode_amplitude);
  if (run.found.stopped) throw Interrupted("stopped before there was a result");
  if (!run.converged()) return;
  const solver::PeriodicSolution& solution = run.found.solution;
  run.power = span::losses_of(solution) * solution.state.frequency / run.shaken->span().built.length;
}

PointError Runs::error_of(const PeriodicSetting& setting, double mass) {
  constexpr analysis::Order in_space{.least = 1.5, .highest = 4, .expected = 2};
  constexpr double by_harmonics_alone = 1.5, by_samples_alone = 1.5, by_points_alone = 1.5;
  PeriodicSetting half = setting, quarter = setting;
  half.elements = std::max(1, setting.elements / 2);
  quarter.elements = std::max(1, setting.elements / 4);
  PeriodicSetting fewer = half, sparser = half, other = half;
  fewer.harmonics = other_harmonics(half.harmonics);
  sparser.samples = std::max(half.samples / 4 * 2, fewest_samples(half.harmonics));
  other.points = build::finer_points(setting.points).value_or(setting.points / 2);
  const PeriodicRun& quick = run(half);
  const bool sampled = half.samples >= fewest_samples(fewer.harmonics);
  const double harmonics = sampled ? by_harmonics_alone * apart(quick, run(fewer)) : INFINITY;
  const double ratio = static_cast<double>(half.samples) / sparser.samples;
  const double samples = ratio > 1 ? by_samples_alone * apart(quick, run(sparser)) / (ratio * ratio - 1) : INFINITY;
  const double points = slips_ ? by_points_alone * apart(quick, run(other)) : 0;
  const double further = apart(quick, run(quarter));
  const double mesh = analysis::richardson(apart(run(setting), quick), further, in_space);
  const PeriodicRun& best = run(setting);
  const double size = std::max(std::abs(best.power), least_power(point_.frequency, point_.antinode_amplitude, mass));
  const auto part = [size](double apart) { return std::isfinite(apart) ? std::optional(apart / size) : std::nullopt; };
  PointError error{.mesh = part(mesh), .harmonics = part(harmonics), .samples = part(samples)};
  if (slips_) error.points = part(points);
  error.relative = part(mesh + harmonics + samples + points);
  error.section_evaluations = effort_.evaluations - best.found.effort.evaluations;
  return error;
}

/// Refines what gives the largest part of the error, of what the case has left open; a part that is not known is the
/// largest. False where nothing is left that would help.
bool refine(PeriodicSetting& setting, const PointError& error, double target, const PeriodicSetting& first,
            const Free& free) {
  const std::optional<int> finer = build::finer_points(setting.points);
  const auto size = [](bool open, const std::optional<double>& part) { return open ? part.value_or(INFINITY) : 0; };
  const double mesh = size(free.elements && setting.elements < most_finer * first.elements, error.mesh);
  const double harmonics = size(
      free.harmonics && setting.harmonics < std::min(most_harmonics, most_finer * first.harmonics), error.harmonics);
  const double samples = size(free.samples && setting.samples < most_samples, error.samples);
  const double points = free.points && finer ? error.points.value_or(0) : 0;
  const double largest = std::max({mesh, harmonics, samples, points});
  double kept = 0;  // what cannot be helped
  for (const auto& [open, part] :
       {std::pair{mesh, error.mesh}, {harmonics, error.harmonics}, {samples, error.samples}, {points, error.points}}) {
    if (open == 0) kept += part.value_or(0);
  }
  if (largest == 0 || kept > target) return false;
  const double wanted = error.relative ? (*error.relative - target) / largest : 1;
  const double factor = std::clamp(1 / std::sqrt(std::max(1 - 1.1 * wanted, 0.01)), 1.15, 2.5);
  if (mesh == largest) {
    const auto elements = static_cast<int>(std::ceil(setting.elements * std::clamp(std::sqrt(factor), 1.2, 1.5)));
    setting.elements = std::min(elements, most_finer * first.elements);
  } else if (harmonics == largest) {
    // Odd ones, half as many again; as many as the samples carry where these are kept.
    int more = std::min((setting.harmonics * 3 / 2) | 1, most_harmonics);
    if (!free.samples) more = std::min(more, setting.samples / 4 - 1);
    if (more <= setting.harmonics) return false;
    setting.harmonics = more;
    if (free.samples) setting.samples = std::max(setting.samples, 2 * fewest_samples(more));
  } else if (samples == largest) {
    setting.samples = std::min(4 * static_cast<int>(std::ceil(setting.samples * factor / 4)), most_samples);
  } else {
    setting.points = *finer;
  }
  return true;
}

}  // namespace

PeriodicSetting first_periodic_setting(const Scene& scene, const Point& point, double target) {
  const Free free(scene);
  const casefile::PeriodicKeys& keys = scene.as<casefile::SelfDampingAnalysis>().periodic;
  Scene own = build::scene_of_point(scene, point.ask());
  if (free.elements) own.span->elements_per_loop = 2.6 / std::pow(target, 0.14);
  PeriodicSetting setting{.elements = static_cast<int>(build::build_span(own).model.elements.size()),
                          .harmonics = keys.harmonics,
                          .samples = keys.samples,
                          .points = scene.section.points};
  if (free.elements) setting.elements = std::max(setting.elements, 8);
  if (free.harmonics) {
    setting.harmonics = target >= 0.05 ? 3 : target >= 0.005 ? 5 : 7;
    if (!free.samples) setting.harmonics = std::min(setting.harmonics, (keys.samples - 4) / 4);
  }
  if (free.samples) {
    setting.samples =
        std::max(2 * fewest_samples(setting.harmonics), 4 * static_cast<int>(std::ceil(2.5 / std::sqrt(target))));
  }
  if (free.points) setting.points = target >= 0.05 ? 20 : 36;
  return setting;
}

PointChoice choice_of(const Scene& scene, const PeriodicSetting& setting) {
  const Free free(scene);
  PointChoice choice;
  if (free.elements) choice.elements = setting.elements;
  if (free.harmonics) choice.harmonics = setting.harmonics;
  if (free.samples) choice.samples = setting.samples;
  if (free.points) choice.points = setting.points;
  return choice;
}

PeriodicToTarget periodic_to_target(const Scene& scene, const Point& point, double target, const Watch& watch) {
  const Free free(scene);
  const double mass = *casefile::mass_per_length(scene);
  const PeriodicSetting first = first_periodic_setting(scene, point, target);
  PeriodicSetting setting = first;
  Runs runs(scene, point, watch);
  PointError error;
  for (int round = 1;; ++round) {
    error = runs.error_of(setting, mass);
    if (error.is_below(target) || round == most_rounds || !refine(setting, error, target, first, free)) break;
  }
  const section::Effort effort = runs.effort();
  return {.run = runs.take(setting), .error = error, .chosen = choice_of(scene, setting), .effort = effort};
}

}  // namespace strandyn::self_damping
