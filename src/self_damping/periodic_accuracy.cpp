#include "strandyn/self_damping/periodic_accuracy.hpp"

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
  Runs(const PeriodicAsk& ask, const PeriodicSetting& first, const Watch& watch)
      : ask_(ask), first_(first), watch_(watch), slips_(build::slips_by_points(ask.scene.section.law)) {}

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

  const PeriodicAsk& ask_;
  PeriodicSetting first_;
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
  run.shaken = shaken_span_of(ask_, setting, watch_.stop);
  const PeriodicRun* start = nearest(setting);
  run.found = start ? run.shaken->resonance(ask_.antinode_amplitude, *start->shaken, start->found.solution.state)
                    : run.shaken->resonance(ask_.antinode_amplitude);
  if (run.found.stopped) throw Interrupted("stopped before there was a result");
  if (!run.converged()) return;
  const solver::PeriodicSolution& solution = run.found.solution;
  run.power = span::losses_of(solution) * solution.state.frequency / run.shaken->span().built.length;
}

/// Each part by its own knob, the others as they were begun with: what one of them asks for raises no other run.
PointError Runs::error_of(const PeriodicSetting& setting, double mass) {
  constexpr analysis::Order in_space{.least = 1.5, .highest = 4, .expected = 2};
  constexpr double by_harmonics_alone = 1.5, by_samples_alone = 1.5, by_points_alone = 1.5;
  constexpr int few = 3;  // harmonics, of a difference of samples or points
  PeriodicSetting fine = first_;
  fine.elements = setting.elements;
  PeriodicSetting half = fine, quarter = fine;
  half.elements = std::max(1, fine.elements / 2);
  quarter.elements = std::max(1, fine.elements / 4);
  PeriodicSetting coarse = first_;
  coarse.elements = std::max(1, first_.elements / 2);
  if (!run(coarse).converged()) coarse.elements = half.elements;
  PeriodicSetting many = coarse;
  many.harmonics = setting.harmonics;
  many.samples = std::max(coarse.samples, std::min(setting.samples, fewest_samples(many.harmonics)));
  PeriodicSetting fewer = many;
  fewer.harmonics = other_harmonics(many.harmonics);
  PeriodicSetting quick = coarse;
  quick.harmonics = std::min(coarse.harmonics, few);
  PeriodicSetting dense = quick, sparse = quick, pointed = quick, other = quick;
  dense.samples = setting.samples;
  sparse.samples = std::max(setting.samples / 4 * 2, fewest_samples(quick.harmonics));
  pointed.points = setting.points;
  other.points = build::finer_points(setting.points).value_or(setting.points / 2);

  const bool sampled = many.samples >= fewest_samples(fewer.harmonics);
  const double harmonics = sampled ? by_harmonics_alone * apart(run(many), run(fewer)) : INFINITY;
  const double ratio = static_cast<double>(dense.samples) / sparse.samples;
  const double samples = ratio > 1 ? by_samples_alone * apart(run(dense), run(sparse)) / (ratio * ratio - 1) : INFINITY;
  const double points = slips_ ? by_points_alone * apart(run(pointed), run(other)) : 0;
  const double further = apart(run(half), run(quarter));
  const double mesh = analysis::richardson(apart(run(fine), run(half)), further, in_space);
  const double size = std::max(std::abs(run(fine).power), least_power(ask_.frequency, ask_.antinode_amplitude, mass));
  const auto part = [size](double apart) { return std::isfinite(apart) ? std::optional(apart / size) : std::nullopt; };
  PointError error{.mesh = part(mesh), .harmonics = part(harmonics), .samples = part(samples)};
  if (slips_) error.points = part(points);
  error.relative = part(mesh + harmonics + samples + points);
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
    if (free.samples) setting.samples = std::max(setting.samples, fewest_samples(more));
  } else if (samples == largest) {
    setting.samples = std::min(4 * static_cast<int>(std::ceil(setting.samples * factor / 4)), most_samples);
  } else {
    setting.points = *finer;
  }
  return true;
}

}  // namespace

std::unique_ptr<span::ShakenSpan> shaken_span_of(const PeriodicAsk& ask, const PeriodicSetting& setting,
                                                 const Stop& stop) {
  Scene scene = ask.scene;
  scene.span->elements = setting.elements;
  scene.section.points = setting.points;
  build::BuiltSpan built = build::build_span(scene);
  const build::Shaker shaker = build::find_shaker(scene, built);
  return std::make_unique<span::ShakenSpan>(
      std::move(built), shaker, ask.frequency,
      span::ResponseOptions{.harmonics = setting.harmonics, .samples = setting.samples, .stop = stop});
}

PeriodicSetting first_periodic_setting(const PeriodicAsk& ask) {
  const Free free(ask.scene);
  const casefile::PeriodicKeys& keys = ask.keys;
  const double target = ask.target;
  Scene own = ask.scene;
  if (free.elements) own.span->elements_per_loop = 2.6 / std::pow(target, 0.14);
  PeriodicSetting setting{.elements = static_cast<int>(build::build_span(own).model.elements.size()),
                          .harmonics = keys.harmonics,
                          .samples = keys.samples,
                          .points = own.section.points};
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

PeriodicToTarget periodic_to_target(const PeriodicAsk& ask, const Watch& watch) {
  const Free free(ask.scene);
  const double mass = *casefile::mass_per_length(ask.scene);
  const PeriodicSetting first = first_periodic_setting(ask);
  PeriodicSetting setting = first;
  Runs runs(ask, first, watch);
  PointError error;
  for (int round = 1;; ++round) {
    error = runs.error_of(setting, mass);
    if (error.is_below(ask.target) || round == most_rounds || !refine(setting, error, ask.target, first, free)) break;
  }
  PeriodicRun run = runs.take(setting);
  const section::Effort effort = runs.effort();
  error.section_evaluations = effort.evaluations - run.found.effort.evaluations;
  return {.run = std::move(run), .error = error, .setting = setting, .effort = effort};
}

}  // namespace strandyn::self_damping
