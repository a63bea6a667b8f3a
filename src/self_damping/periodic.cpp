#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "methods.hpp"
#include "strandyn/analysis/methods.hpp"
#include "strandyn/self_damping/periodic_accuracy.hpp"

namespace strandyn::self_damping {

using casefile::Scene;
using span::ResonanceAt;
using span::ShakenSpan;
using std::numbers::pi;

namespace {

PointResult failed(std::string why, const ResonanceAt& found) {
  return {.effort = found.effort, .failure = std::move(why), .stopped = found.stopped};
}

/// [-] bending stiffness over EI_max of the tensioned beam that has the resonance at the mean tension of the vibration;
/// its wave is as long as EI_max at rest makes it.
double effective_stiffness(const build::BuiltSpan& built, const Point& point, double resonance, double mean_tension) {
  const build::SectionNumbers& numbers = built.numbers;
  const double mass = built.model.inertia.mass;
  const double EI_max = numbers.EI_max;
  const double k =
      analysis::wavenumber({.tension = point.tension, .mass_per_length = mass, .EI = EI_max}, point.frequency);
  const double stretched = mass / (1 + point.tension / numbers.EA);  // the chain's mass is that of unstressed length
  return (stretched * std::pow(2 * pi * resonance, 2) - mean_tension * k * k) / (EI_max * std::pow(k, 4));
}

PointResult result_of(const ShakenSpan& shaken, const Point& point, const ResonanceAt& found) {
  const solver::PeriodicSolution& s = found.solution;
  const build::BuiltSpan& built = shaken.span().built;
  const double length = built.length;
  const double frequency = s.state.frequency;
  PointResult result{.self_damping = span::losses_of(s) * frequency / length, .effort = found.effort};
  const span::StrainRange strains = shaken.strains(s.state);
  SpanVibration v{.mode = shaken.mode_number(),
                  .span_length = length,
                  .elements = built.model.elements.size(),
                  .sticking_frequency = shaken.mode().frequency,
                  .resonance = frequency,
                  .reached_amplitude = found.antinode_amplitude,
                  .drive_power = s.drive_power,
                  .mean_tension = strains.mean_tension,
                  .highest_tension = strains.highest_tension,
                  .harmonics = static_cast<int>(s.state.harmonics.cols() - 1) / 2,
                  .iterations = s.iterations,
                  .loop_cycles = s.cycles,
                  .loop_closure = s.loop_gap};
  (shaken.drive_kind() == solver::DriveKind::force ? v.drive_force : v.drive_motion) = s.state.drive;
  LossParts parts{.friction = span::friction_of(s) * frequency / length,
                  .material = s.material * frequency / length,
                  .viscous = s.viscous.total() * frequency / length,
                  .air = s.air * frequency / length};
  if (span::losses_of(s) + s.air > 0) v.imbalance = s.imbalance();
  const double velocity = 2 * pi * frequency * point.antinode_amplitude;
  v.loss_factor = analysis::loss_factor(analysis::damping_ratio(
      result.self_damping,
      {.mass_per_length = built.model.inertia.mass, .frequency = frequency, .velocity = velocity}));
  v.effective_EI = effective_stiffness(built, point, frequency, strains.mean_tension);
  if (const auto free = shaken.free_span(s, strains)) {
    const double per_length = frequency / (free->to - free->from);
    result.free_span = (free->friction + free->material) * per_length;
    parts.material_free_span = free->material * per_length;
    parts.air_free_span = free->air * per_length;
    v.free_span_from = free->from;
    v.free_span_to = free->to;
    v.free_span_curvature = free->curvature;
    v.highest_curvature = free->highest;
  }
  result.parts = parts;
  result.vibration = v;
  return result;
}

PeriodicAsk ask_of(const Scene& scene, const Point& point, double target) {
  return {.scene = build::scene_of_point(scene, point.ask()),
          .keys = scene.as<casefile::SelfDampingAnalysis>().periodic,
          .frequency = point.frequency,
          .antinode_amplitude = point.antinode_amplitude,
          .target = target};
}

}  // namespace

PeriodicMethod::PeriodicMethod(const Scene& scene) : scene_(scene) {
  const casefile::PeriodicKeys& keys = scene.as<casefile::SelfDampingAnalysis>().periodic;
  options_ = {.harmonics = keys.harmonics, .samples = keys.samples};
  build::shaker_of(scene);
}

PointResult PeriodicMethod::to_target(const Point& point, double target, const Watch& watch) const {
  try {
    const PeriodicToTarget reached = periodic_to_target(ask_of(scene_, point, target), watch);
    PointResult result = reached.run.converged() ? result_of(*reached.run.shaken, point, reached.run.found)
                                                 : failed(reached.run.found.solution.failure, reached.run.found);
    result.effort = reached.effort;
    result.error = reached.error;
    result.chosen = choice_of(scene_, reached.setting);
    return result;
  } catch (const Interrupted&) {
    return {.stopped = true};
  }
}

PointResult PeriodicMethod::at(const Point& point, const Watch& watch) const {
  if (const std::optional<double> target = casefile::target_error(scene_)) return to_target(point, *target, watch);
  const Scene own = build::scene_of_point(scene_, point.ask());
  build::BuiltSpan built = build::build_span(own);
  const build::Shaker shaker = build::find_shaker(own, built);
  span::ResponseOptions options = options_;
  options.stop = watch.stop;
  std::optional<ShakenSpan> shaken;
  try {
    shaken.emplace(std::move(built), shaker, point.frequency, options);
  } catch (const Interrupted&) {
    return {.stopped = true};
  }
  const ResonanceAt found = shaken->resonance(point.antinode_amplitude);
  if (found.stopped || !found.solution.converged) return failed(found.solution.failure, found);
  return result_of(*shaken, point, found);
}

std::optional<PointChoice> PeriodicMethod::first_choice(const Point& point) const {
  const std::optional<double> target = casefile::target_error(scene_);
  if (!target) return std::nullopt;
  return choice_of(scene_, first_periodic_setting(ask_of(scene_, point, *target)));
}

PeriodicMethod::Trial PeriodicMethod::try_coarse(const Point& point) const {
  constexpr int harmonics = 3, samples = 32;
  constexpr double tolerance = 1e-3, most_seconds = 2;
  Scene own = build::scene_of_point(scene_, point.ask());
  own.span->elements = std::max(8, static_cast<int>(build::build_span(own).model.elements.size() / 2));
  const std::clock_t start = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  try {
    build::BuiltSpan built = build::build_span(own);
    const double loop = static_cast<double>(built.section_points()) * samples;
    const build::Shaker shaker = build::find_shaker(own, built);
    const ShakenSpan shaken(std::move(built), shaker, point.frequency,
                            {.harmonics = harmonics, .samples = samples, .tolerance = tolerance, .stop = [&] {
                               return seconds() > most_seconds;
                             }});
    const ResonanceAt found = shaken.resonance(point.antinode_amplitude);
    const auto evaluations = static_cast<double>(found.effort.evaluations);
    if (evaluations > 0) {
      return {.rounds = evaluations / loop,
              .seconds = seconds() / evaluations,
              .slips = !found.solution.converged || found.solution.friction > 0,
              .loops = shaken.mode_number()};
    }
  } catch (const ComputationError&) {  // too coarse for its modes
  } catch (const InputError&) {
  } catch (const Interrupted&) {
  }
  return {.rounds = 300, .seconds = 0, .slips = true};
}

PeriodicMethod::Size PeriodicMethod::size_of(const Point& point) const {
  Scene own = build::scene_of_point(scene_, point.ask());
  const PointChoice choice = first_choice(point).value_or(PointChoice{});
  if (choice.elements) own.span->elements = choice.elements;
  const build::BuiltSpan span = build::build_span(own);
  return {.loops = static_cast<double>(span.section_points()) * choice.samples.value_or(options_.samples),
          .coefficients = 2.0 * choice.harmonics.value_or(options_.harmonics) + 1};
}

/// Once around each loop for each coefficient of the harmonics and again in the search for the amplitude: 44 to 430
/// times in the cases that ship, up to 600 in random ones, 20 where nothing slips; of a chosen accuracy six times as
/// much.
Expected PeriodicMethod::expected(const std::vector<Point>& points) const {
  Expected expected;
  for (const Point& point : points) {
    const Size size = size_of(point);
    const double estimates = casefile::target_error(scene_) ? 6 : 1;
    const double loop = estimates * size.loops * 4 * size.coefficients / 11;
    expected += Expected{.least = 11 * loop, .most = 108 * loop};
  }
  return expected;
}

/// By a coarse point of three harmonics. Measured on random points of 1 to 60 loops: five harmonics go 1.3 to 2.7 times
/// as often around their loops, where wires slip once for each coefficient. A chosen accuracy takes 1.5 to 4 times what
/// its first setting takes on three loops and fewer, up to 10 times on many; 1.6 to 4 times where nothing slips.
std::optional<Expected> PeriodicMethod::expected_by_trial(const std::vector<Point>& points) const {
  constexpr double again = 1.8, within = 3.1, coefficients_of_default = 11;
  constexpr double estimates_of_none = 2.4;
  const auto estimates_of_slip = [](int loops) { return std::min(2.6 * std::pow(loops, 0.6), 8.5); };
  constexpr double beside_sections = 1.9;  // of a chosen accuracy: so many spans and modes for short runs
  constexpr std::size_t most_tried = 3;    // the first, one between, and the last of many
  const std::size_t every = std::max<std::size_t>(1, (points.size() + most_tried - 2) / (most_tried - 1));
  Expected expected;
  Trial trial;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % every == 0 || i + 1 == points.size()) trial = try_coarse(points[i]);
    const Size size = size_of(points[i]);
    double rounds = again * trial.rounds;
    if (trial.slips) rounds *= size.coefficients / coefficients_of_default;
    if (casefile::target_error(scene_)) rounds *= trial.slips ? estimates_of_slip(trial.loops) : estimates_of_none;
    const double evaluations = rounds * size.loops;
    const double beside = casefile::target_error(scene_) ? beside_sections : 1;
    expected += Expected{
        .least = evaluations / within, .most = evaluations * within, .seconds = evaluations * trial.seconds * beside};
  }
  return expected;
}

}  // namespace strandyn::self_damping
