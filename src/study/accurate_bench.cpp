#include "accurate_bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setting_choice.hpp"
#include "strandyn/build/point.hpp"

namespace strandyn::study {

using casefile::Scene;
using self_damping::Expected;
using self_damping::Point;
using self_damping::PointChoice;
using self_damping::PointResult;
using self_damping::Watch;

namespace {

/// Part of the target that the bench's amplitude may take.
constexpr double share_of_amplitude = 0.25;

/// The loss of a steady cycle, brought to the amplitude that was asked for; by a bench that is not let go for long, and
/// comes as near to its amplitude as is cheap.
LossRun bench_run(const Point& point, const Watch& watch) {
  return [&point, &watch](const Scene& scene, const Hooks&, Cost& cost) {
    constexpr int few_decay_cycles = 6, most_cycles = 800;
    Scene own = scene;
    casefile::BenchKeys& keys = std::get<casefile::SelfDampingAnalysis>(own.analysis).bench;
    keys.decay_cycles = few_decay_cycles;
    keys.max_cycles = std::min(keys.max_cycles, most_cycles);
    const PointResult result = self_damping::make_method(casefile::DampingMethod::transient, own)->at(point, watch);
    cost.section_evaluations += result.effort.evaluations;
    cost.section_sweeps += result.effort.sweeps;
    Lost lost{.interrupted = result.stopped};
    if (result.bench) {
      const double per_power = result.bench->span_length / result.bench->frequency;
      const double off = point.antinode_amplitude / result.bench->antinode_amplitude;
      lost.dissipation = {result.self_damping * per_power * std::pow(off, result.bench->loss_exponent)};
      const double mass = *casefile::mass_per_length(own);
      // Of a sine, in its motion through rest.
      const double velocity = 2 * std::numbers::pi * point.frequency * point.antinode_amplitude;
      lost.energy = mass * result.bench->span_length * velocity * velocity / 4;
    }
    return lost;
  };
}

class BenchToTarget final : public self_damping::Method {
 public:
  explicit BenchToTarget(const Scene& scene) : scene_(scene), target_(*casefile::target_error(scene)) {
    Scene bare = scene;
    bare.accuracy.reset();
    self_damping::make_method(word, bare);  // refuses what a bench cannot do
  }

  PointResult at(const Point& point, const Watch& watch) const override {
    const Scene own = build::scene_of_point(scene_, point.ask());
    SettingChoice choice(own, allowed(), bench_run(point, watch));
    Cost cost;
    ErrorEstimate estimate;
    try {
      const Hooks hooks{.stop = watch.stop, .progress = [&](double, std::string_view words) {
                          if (watch.tell) watch.tell(std::string(words));
                        }};
      estimate = choice.search(hooks, cost);
    } catch (const Interrupted&) {
      return {.stopped = true};
    }
    PointResult result = kept(choice, point, watch);
    result.effort.evaluations += cost.section_evaluations;
    result.effort.sweeps += cost.section_sweeps;
    if (!result.bench) return result;
    const auto known = [](double part) { return std::isfinite(part) ? std::optional(part) : std::nullopt; };
    const double off = std::abs(result.bench->antinode_amplitude / point.antinode_amplitude - 1);
    self_damping::PointError error{.mesh = known(estimate.mesh),
                                   .time = known(estimate.time),
                                   .amplitude = result.bench->loss_exponent * off,
                                   .section_evaluations = cost.section_evaluations};
    if (estimate.points) error.points = known(*estimate.points);
    error.relative = known(estimate.relative() + *error.amplitude);
    result.error = error;
    result.chosen = choice_of(choice);
    return result;
  }

  std::optional<PointChoice> first_choice(const Point& point) const override {
    const Scene own = build::scene_of_point(scene_, point.ask());
    return choice_of(SettingChoice(own, allowed()));
  }

  /// The benches of the estimate take half as much again as the one that is kept.
  Expected expected(const std::vector<Point>& points) const override {
    constexpr double estimated = 2, refined = 5;
    Expected all;
    for (const Point& point : points) {
      const Scene own = build::scene_of_point(scene_, point.ask());
      const Scene bench = bench_of(SettingChoice(own, allowed()), tolerance());
      Expected one = self_damping::make_method(word, bench)->expected({point});
      one.least *= estimated;
      one.most *= refined;
      all += one;
    }
    return all;
  }

 private:
  static constexpr auto word = casefile::DampingMethod::transient;

  double allowed() const { return (1 - share_of_amplitude) * target_; }
  /// Where the bench does not settle that near, as near as without an accuracy; the estimate says so.
  PointResult kept(const SettingChoice& choice, const Point& point, const Watch& watch) const {
    const double given = scene_.as<casefile::SelfDampingAnalysis>().bench.amplitude_tolerance;
    try {
      return self_damping::make_method(word, bench_of(choice, tolerance()))->at(point, watch);
    } catch (const ComputationError&) {
      if (tolerance() == given) throw;
    }
    return self_damping::make_method(word, bench_of(choice, given))->at(point, watch);
  }
  bool tolerance_is_free() const { return !scene_.source.find("analysis.bench.amplitude_tolerance"); }
  double tolerance() const {
    const double given = scene_.as<casefile::SelfDampingAnalysis>().bench.amplitude_tolerance;
    constexpr double exponent = 3;  // of most losses
    return tolerance_is_free() ? std::min(given, share_of_amplitude * target_ / exponent) : given;
  }

  Scene bench_of(const SettingChoice& choice, double amplitude_tolerance) const {
    Scene bench = with_setting(scene_, choice.setting());
    bench.accuracy.reset();
    bench.integrator.method = choice.scene().integrator.method;
    std::get<casefile::SelfDampingAnalysis>(bench.analysis).bench.amplitude_tolerance = amplitude_tolerance;
    return bench;
  }

  PointChoice choice_of(const SettingChoice& choice) const {
    const ChosenKeys keys = choice.keys();
    PointChoice chosen{.elements = keys.span.elements,
                       .method = keys.integrator.method,
                       .steps_per_cycle = keys.integrator.steps_per_cycle,
                       .points = keys.section.points};
    if (tolerance_is_free()) chosen.amplitude_tolerance = tolerance();
    return chosen;
  }

  const Scene& scene_;
  double target_;
};

}  // namespace

std::unique_ptr<self_damping::Method> bench_to_target(const Scene& scene) {
  return std::make_unique<BenchToTarget>(scene);
}

}  // namespace strandyn::study
