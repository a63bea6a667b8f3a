#include "self_damping_periodic.hpp"

#include <cmath>
#include <numbers>

#include "shaken_span.hpp"
#include "strandyn/analysis/methods.hpp"

namespace strandyn::study {

using casefile::Scene;
using std::numbers::pi;

namespace {

void move_places(Scene& scene, double old_length, double new_length) {
  const auto move = [&](double& at) {
    if (at > old_length / 2) at += new_length - old_length;
  };
  for (casefile::Load& load : scene.loads) {
    if (load.at) move(*load.at);
  }
  for (casefile::Motion& motion : scene.motions) {
    if (motion.at) move(*motion.at);
  }
  for (casefile::Body& body : scene.bodies) move(body.at);
}

PointResult failed(std::string why, const ResonanceAt& found) {
  return {.effort = found.effort, .failure = std::move(why), .stopped = found.stopped};
}

/// [-] bending stiffness over EI_max of the tensioned beam that has the resonance at the mean tension of the vibration;
/// its wave is as long as EI_max at rest makes it.
double effective_stiffness(const Scene& scene, const Point& point, double resonance, double mean_tension) {
  const build::SectionNumbers numbers = build::section_numbers(scene);
  const double mass = *casefile::mass_per_length(scene);
  const double EI_max = numbers.EI_max;
  const double k =
      analysis::wavenumber({.tension = point.tension, .mass_per_length = mass, .EI = EI_max}, point.frequency);
  const double stretched = mass / (1 + point.tension / numbers.EA);  // the chain's mass is that of unstressed length
  return (stretched * std::pow(2 * pi * resonance, 2) - mean_tension * k * k) / (EI_max * std::pow(k, 4));
}

PointResult result_of(const Scene& scene, const ShakenSpan& shaken, const Point& point, const ResonanceAt& found) {
  const solver::PeriodicSolution& s = found.solution;
  const double length = shaken.span().built.length;
  const double frequency = s.state.frequency;
  PointResult result{.self_damping = losses_of(s) * frequency / length, .effort = found.effort};
  const StrainRange strains = shaken.strains(s.state);
  result.details = {{"mode", shaken.mode_number()},
                    {"span_length_m", length},
                    {"elements", shaken.span().built.model.elements.size()},
                    {"sticking_frequency_Hz", shaken.mode().frequency},
                    {"resonance_Hz", frequency},
                    {"reached_amplitude_m", found.antinode_amplitude},
                    {"friction_W_per_m", friction_of(s) * frequency / length},
                    {"viscous_W_per_m", s.viscous.total() * frequency / length},
                    {"drive_power_W", s.drive_power}};
  auto& details = result.details;
  details[shaken.drive_kind() == solver::DriveKind::force ? "drive_force_N" : "drive_motion_m"] = s.state.drive;
  if (losses_of(s) > 0) details["imbalance"] = s.imbalance();
  const double velocity = 2 * pi * frequency * point.antinode_amplitude;
  details["loss_factor"] = analysis::loss_factor(analysis::damping_ratio(
      result.self_damping,
      {.mass_per_length = shaken.span().built.model.inertia.mass, .frequency = frequency, .velocity = velocity}));
  details["effective_EI_over_EI_max"] = effective_stiffness(scene, point, frequency, strains.mean_tension);
  details["mean_tension_N"] = strains.mean_tension;
  details["highest_tension_N"] = strains.highest_tension;
  if (const auto free = shaken.free_span(s, strains)) {
    result.free_span = free->friction * frequency / (free->to - free->from);
    details["free_span_from_m"] = free->from;
    details["free_span_to_m"] = free->to;
    details["free_span_curvature_per_m"] = free->curvature;
    details["highest_curvature_per_m"] = free->highest;
  }
  details["harmonics"] = (s.state.harmonics.cols() - 1) / 2;
  details["iterations"] = s.iterations;
  details["loop_cycles"] = s.cycles;
  details["loop_closure"] = s.loop_gap;
  return result;
}

}  // namespace

SpanOfPoint span_of_point(const Scene& scene, const Point& point) {
  const casefile::Span& span = *scene.span;
  if (point.mode) return {.mode = *point.mode, .length = *span.length};
  const double mass = *casefile::mass_per_length(scene);
  const double EI = build::section_numbers(scene).EI_max;
  const double k = analysis::wavenumber({.tension = point.tension, .mass_per_length = mass, .EI = EI}, point.frequency);
  // k L = n pi + atan(k/q) for each clamped end, where the boundary layers of the two do not meet.
  const double q = std::sqrt(k * k + point.tension / EI);
  const int clamped =
      (span.left == casefile::Support::clamped ? 1 : 0) + (span.right == casefile::Support::clamped ? 1 : 0);
  const double turn = clamped * std::atan(k / q);
  const int mode = std::max(1, static_cast<int>(std::lround((k * *span.length - turn) / pi)));
  return {.mode = mode, .length = (mode * pi + turn) / k};
}

Scene scene_of_point(const Scene& scene, const Point& point, double shaker_place) {
  const SpanOfPoint wanted = span_of_point(scene, point);
  Scene own = scene;
  move_places(own, *scene.span->length, wanted.length);
  own.span->length = wanted.length;
  own.span->tension = point.tension;
  own.span->tension_rts.reset();
  own.span->unstressed_length.reset();
  const Shaker shaker = shaker_of(scene);
  if (!shaker.load && !shaker.motion) {
    casefile::Load force;
    force.type = casefile::LoadType::harmonic_force;
    force.at = shaker_place * wanted.length / wanted.mode;
    force.amplitude = 1;
    force.direction = casefile::Vector3{0, 1, 0};
    own.loads.push_back(force);
  }
  // The mesh looks at the drive for the waves that it must carry.
  const auto at_mode = [&wanted](auto& drive) {
    drive.frequency.reset();
    drive.frequency_mode = wanted.mode;
  };
  shaker.motion ? at_mode(own.motions[*shaker.motion])
                : at_mode(shaker.load ? own.loads[*shaker.load] : own.loads.back());
  return own;
}

Road periodic_road(const RoadContext& context) {
  shaker_of(context.scene);
  return [&scene = context.scene, stop = context.stop](const Point& point) -> PointResult {
    if (stop && stop()) return {.stopped = true};
    const ShakenSpan shaken(scene_of_point(scene, point), point.frequency, scene.analysis.self_damping.periodic);
    const ResonanceAt found = shaken.resonance(point.antinode_amplitude, stop);
    if (found.stopped || !found.solution.converged) return failed(found.solution.failure, found);
    return result_of(scene, shaken, point, found);
  };
}

double expected_evaluations(const Scene& scene, const Point& point) {
  const Scene own = scene_of_point(scene, point);
  const build::BuiltSpan span = build::build_span(own);
  const auto points = static_cast<double>(span.model.elements.size() * beam::gauss_points);
  // Counted on slipping spans: some ten times around the loops and derivatives by each coefficient twice, each two
  // cycles of one commit and one response.
  constexpr double loops = 10, derivatives = 2, per_sample = 4;
  const casefile::PeriodicKeys& keys = scene.analysis.self_damping.periodic;
  return points * keys.samples * per_sample * (loops + derivatives * (2 * keys.harmonics + 1));
}

}  // namespace strandyn::study
