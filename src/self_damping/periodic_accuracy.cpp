#include "strandyn/self_damping/periodic_accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "strandyn/analysis/richardson.hpp"

namespace strandyn::self_damping {

using casefile::Scene;

namespace {

constexpr int most_rounds = 14;
constexpr int most_finer = 4;    ///< times the elements and the harmonics begun with
constexpr int finest_level = 4;  ///< of a mesh: `most_finer` times the elements
constexpr double rough = 1e-4;   ///< [-] of the target: corrections that end a solution
constexpr int most_harmonics = 31, most_samples = 1024;

int fewest_samples(int harmonics) {
  return 4 * harmonics + 4;
}

/// Odd ones, half as many again: even ones hardly count.
int more_harmonics(int harmonics) {
  return std::min((harmonics * 3 / 2) | 1, most_harmonics);
}

/// Of five and fewer two more; else those that a refinement would take, so that their run is there for it. Fewer say
/// nothing: of 3, 5, 7, 11 harmonics the loss may fall and rise again (2 loops in gross slip: 3 and 7 agreed within
/// 2e-5, 11 lay 4e-3 above).
int other_harmonics(int harmonics) {
  const int more = harmonics > 5 ? more_harmonics(harmonics) : harmonics + 2;
  return more > harmonics ? more : (harmonics / 2) | 1;
}

/// Meshes are finer by the root of two from one to the next, so that a refinement adds one run to those that are there.
int elements_at(int level, const PeriodicSetting& first) {
  return std::max(2, static_cast<int>(std::lround(first.elements * std::exp2(level / 2.0))));
}
int level_of(int elements, const PeriodicSetting& first) {
  return static_cast<int>(std::lround(2 * std::log2(static_cast<double>(elements) / first.elements)));
}

/// The coarsest mesh that has two elements, or nearly, for half a wave of the highest harmonic of so many loops: a
/// coarser one has its modes elsewhere.
int level_for(int harmonics, int loops, const PeriodicSetting& first) {
  constexpr double elements = 1.8;
  const double wanted = elements * harmonics * loops / first.elements;
  return std::clamp(static_cast<int>(std::ceil(2 * std::log2(wanted))), 1 - finest_level, finest_level);
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
  /// Of the mode; 1 where no run has found one.
  int loops() const {
    for (const auto& [setting, run] : runs_) {
      if (run.shaken) return run.shaken->mode_number();
    }
    return 1;
  }
  PeriodicRun take(const PeriodicSetting& setting) { return std::move(run(setting)); }

 private:
  void solve(const PeriodicSetting& setting, PeriodicRun& run) const;
  double by_harmonics(const PeriodicSetting& coarse, const PeriodicSetting& setting);
  /// A run that is there, as near as can be: with as many harmonics, so that its sections are known; on the same mesh,
  /// else on the finest.
  const PeriodicRun* nearest(const PeriodicSetting& setting) const {
    const PeriodicRun* best = nullptr;
    std::tuple<bool, bool, int> nearness;
    for (const auto& [other, run] : runs_) {
      const std::tuple own(other.harmonics >= setting.harmonics, other.elements == setting.elements, other.elements);
      if (!run.converged() || (best && own <= nearness)) continue;
      best = &run;
      nearness = own;
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

/// [W/m] No order is taken for granted: of a strand that is nearly a string each odd harmonic lies near a mode, and
/// each adds as much as the one before.
double Runs::by_harmonics(const PeriodicSetting& coarse, const PeriodicSetting& setting) {
  constexpr double safety = 1.5;
  const int other = other_harmonics(setting.harmonics);
  const int level = level_for(std::max(setting.harmonics, other), loops(), first_);
  const auto with = [&](int harmonics) -> const PeriodicRun& {
    PeriodicSetting own = coarse;
    own.elements = std::max(coarse.elements, elements_at(level, first_));
    own.harmonics = harmonics;
    own.samples = std::max(coarse.samples, fewest_samples(std::max(setting.harmonics, other)));
    return run(own);
  };
  return safety * apart(with(setting.harmonics), with(other));
}

/// Each part by its own knob, the others as they were begun with: what one of them asks for raises no other run.
PointError Runs::error_of(const PeriodicSetting& setting, double mass) {
  constexpr analysis::Order in_space{.least = 1.5, .highest = 4, .expected = 2, .ratio = std::numbers::sqrt2};
  constexpr double by_samples_alone = 1.5, by_points_alone = 1.5;
  constexpr int few = 3;  // harmonics, of a difference of samples or points
  PeriodicSetting fine = first_;
  fine.elements = setting.elements;
  const int level = level_of(setting.elements, first_);
  PeriodicSetting before = fine, further = fine;
  before.elements = elements_at(level - 1, first_);
  further.elements = elements_at(level - 2, first_);
  run(further);  // the cheapest one is begun with
  PeriodicSetting coarse = first_;
  coarse.elements = elements_at(-1, first_);
  if (!run(coarse).converged()) coarse.elements = before.elements;
  PeriodicSetting quick = coarse;
  quick.harmonics = std::min({coarse.harmonics, few, (setting.samples / 2 - 4) / 4});
  PeriodicSetting dense = quick, sparse = quick, pointed = quick, other = quick;
  dense.samples = setting.samples;
  sparse.samples = std::max(setting.samples / 4 * 2, fewest_samples(quick.harmonics));
  pointed.points = setting.points;
  other.points =
      setting.points > first_.points ? first_.points : build::finer_points(setting.points).value_or(setting.points / 2);

  const double harmonics = by_harmonics(coarse, setting);
  const double ratio = static_cast<double>(dense.samples) / sparse.samples;
  const double samples = ratio > 1 ? by_samples_alone * apart(run(dense), run(sparse)) / (ratio * ratio - 1) : INFINITY;
  const double more = static_cast<double>(pointed.points) / other.points;
  const double of_points = by_points_alone / (more > 1 ? more * more - 1 : 1);
  const double points = slips_ ? of_points * apart(run(pointed), run(other)) : 0;
  const double mesh = analysis::richardson(apart(run(fine), run(before)), apart(run(before), run(further)), in_space);
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
            const Free& free, int loops) {
  const int level = level_of(setting.elements, first);
  const std::optional<int> finer = build::finer_points(setting.points);
  const auto size = [](bool open, const std::optional<double>& part) { return open ? part.value_or(INFINITY) : 0; };
  const double mesh = size(free.elements && level < finest_level, error.mesh);
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
    setting.elements = elements_at(level + 1, first);
  } else if (harmonics == largest) {
    // As many as the samples carry where these are kept.
    int more = more_harmonics(setting.harmonics);
    if (!free.samples) more = std::min(more, setting.samples / 4 - 1);
    if (more <= setting.harmonics) return false;
    setting.harmonics = more;
    if (free.samples) setting.samples = std::max(setting.samples, fewest_samples(more));
    if (free.elements) {
      setting.elements = std::max(setting.elements, elements_at(level_for(more, loops, first), first));
    }
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
      span::ResponseOptions{
          .harmonics = setting.harmonics, .samples = setting.samples, .tolerance = rough * ask.target, .stop = stop});
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
    // They leave 5/S^2; a quarter of the target is theirs.
    setting.samples =
        std::max(fewest_samples(setting.harmonics), 4 * static_cast<int>(std::ceil(std::sqrt(20 / target) / 4)));
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
    if (error.is_below(ask.target) || round == most_rounds ||
        !refine(setting, error, ask.target, first, free, runs.loops()))
      break;
  }
  PeriodicRun run = runs.take(setting);
  const section::Effort effort = runs.effort();
  error.section_evaluations = effort.evaluations - run.found.effort.evaluations;
  return {.run = std::move(run), .error = error, .setting = setting, .effort = effort};
}

}  // namespace strandyn::self_damping
