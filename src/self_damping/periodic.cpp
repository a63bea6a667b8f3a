#include <cmath>
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

/// Loops of all sections over the samples of a cycle, once for each coefficient of the harmonics and again in the
/// search for the amplitude: 11 to 110 times a loop in the cases that ship, up to 150 in random ones, 5 where nothing
/// slips; of a chosen accuracy six times as much.
Expected PeriodicMethod::expected(const std::vector<Point>& points) const {
  Expected expected;
  for (const Point& point : points) {
    Scene own = build::scene_of_point(scene_, point.ask());
    const PointChoice choice = first_choice(point).value_or(PointChoice{});
    if (choice.elements) own.span->elements = choice.elements;
    const build::BuiltSpan span = build::build_span(own);
    const double coefficients = 2.0 * choice.harmonics.value_or(options_.harmonics) + 1;
    const double estimates = casefile::target_error(scene_) ? 6 : 1;
    const double loop = estimates * static_cast<double>(span.section_points()) *
                        choice.samples.value_or(options_.samples) * 4 * coefficients / 11;
    expected += Expected{.least = 11 * loop, .most = 108 * loop};
  }
  return expected;
}

}  // namespace strandyn::self_damping
