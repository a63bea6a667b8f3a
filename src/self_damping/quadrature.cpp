#include "strandyn/self_damping/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/air/still_air.hpp"
#include "strandyn/air/wind_power.hpp"
#include "strandyn/analysis/methods.hpp"
#include "strandyn/core/side_by_side.hpp"
#include "strandyn/self_damping/mode_loss.hpp"
#include "table_accuracy.hpp"

namespace strandyn::self_damping {

using casefile::DampingMethod;
using casefile::Scene;

namespace {

const casefile::SelfDampingAnalysis& keys_of(const Scene& scene) {
  return scene.as<casefile::SelfDampingAnalysis>();
}

Wave wave_of(const Point& point, double mass) {
  return {.tension = point.tension,
          .mass_per_length = mass,
          .frequency = point.frequency,
          .antinode_amplitude = point.antinode_amplitude};
}

/// [1/m] the lowest and the highest curvature amplitude that a point may ask for.
CurvatureRange curvatures_of(const Scene& scene, const build::SectionNumbers& numbers, double mass,
                             const Point& point) {
  const auto& keys = scene.as<casefile::SelfDampingAnalysis>();
  const double of_string = string_loop(wave_of(point, mass)).curvature;
  if (keys.mode_shape == casefile::ModeShape::string) return {.lowest = of_string, .highest = of_string};
  if (keys.mode_shape == casefile::ModeShape::sine) {
    const double k = analysis::wavenumber({.tension = point.tension, .mass_per_length = mass, .EI = numbers.EI_max},
                                          point.frequency);
    return {.lowest = k * k * point.antinode_amplitude, .highest = of_string};
  }
  const ClampedCurvature chi = curvature_of(clamped_mode_at(
      {.tension = point.tension, .EI = numbers.EI_max, .mass_per_length = mass, .length = *scene.span->length},
      point.frequency));
  return {.lowest = chi.free_span * point.antinode_amplitude, .highest = chi.largest * point.antinode_amplitude};
}

bool goes_over_clamped_modes(const Scene& scene) {
  return keys_of(scene).mode_shape == casefile::ModeShape::clamped;
}

exact::TensionedBeam beam_of(const Scene& scene, const build::SectionNumbers& numbers, double tension) {
  return {.tension = tension,
          .EI = numbers.EI_max,
          .mass_per_length = *casefile::mass_per_length(scene),
          .length = *scene.span->length};
}

/// Those at which the error of a table is looked for: of rising amplitudes, both ends among them.
std::vector<Point> some_of(std::vector<Point> points) {
  constexpr std::size_t most = 3;
  std::ranges::stable_sort(points, {}, [](const Point& p) { return p.frequency * p.frequency * p.antinode_amplitude; });
  if (points.size() <= most) return points;
  std::vector<Point> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * (points.size() - 1) / (most - 1)]);
  return some;
}

/// The points whose sectional loss will be asked for: its own, and the ends of every energy balance.
std::vector<Point> points_of_quadrature(const Scene& scene, const std::vector<Point>& all) {
  const casefile::SelfDampingAnalysis& a = keys_of(scene);
  const double diameter = build::section_numbers(scene).diameter;
  std::vector<Point> points;
  std::ranges::copy_if(all, std::back_inserter(points),
                       [](const Point& point) { return point.method == DampingMethod::quadrature; });
  for (const casefile::EnergyBalanceKeys& balance : a.energy_balances) {
    if (balance.self_damping != casefile::BalancedBy::quadrature) continue;
    for (double tension : distinct_tensions(all)) {
      for (double frequency : balance.frequencies.empty() ? a.frequencies : balance.frequencies) {
        for (const air::WindPowerCurve* curve : air::wind_power_curves()) {
          for (double part : {curve->lowest, curve->highest}) {
            points.push_back({.frequency = frequency, .antinode_amplitude = part * diameter, .tension = tension});
          }
        }
      }
    }
  }
  return points;
}

}  // namespace

Quadrature::Quadrature(const Scene& scene)
    : scene_(scene),
      numbers_(build::section_numbers(scene)),
      mass_(*casefile::mass_per_length(scene)),
      surroundings_(build::surroundings(scene)),
      law_(build::build_law(scene, section::Dimension::planar)) {}

void Quadrature::begin(const std::vector<Point>& all, const Beginning& how) {
  const std::vector<Point> points = points_of_quadrature(scene_, all);
  std::vector<double> tensions = distinct_tensions(points);
  if (how.tensions) {
    std::erase_if(tensions,
                  [&](double tension) { return std::ranges::find(*how.tensions, tension) == how.tensions->end(); });
  }
  std::vector<LossTable> made(tensions.size());
  side_by_side(tensions.size(), [&](std::size_t i) { made[i] = loss_table(tensions[i], points, how); });
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    tables_.push_back({.tension = tensions[i],
                       .loss = SectionalLoss(made[i]),
                       .material = build::material_loss(scene_, tensions[i]),
                       .error = made[i].error,
                       .chosen = made[i].chosen});
  }
}

LossTable Quadrature::loss_table(double tension, const std::vector<Point>& points, const Beginning& how) const {
  std::vector<Point> own;
  std::ranges::copy_if(points, std::back_inserter(own), [&](const Point& point) { return point.tension == tension; });
  CurvatureRange range{.lowest = INFINITY, .highest = 0};
  for (const Point& point : own) {
    const CurvatureRange chi = curvatures_of(scene_, numbers_, mass_, point);
    range.lowest = std::min(range.lowest, chi.lowest);
    range.highest = std::max(range.highest, chi.highest);
  }
  if (how.find) {
    if (const std::optional<LossTable> kept = how.find(tension, range)) return *kept;
  }
  LossTable table = make_table(tension, own, range, how.stop);
  table.tension = tension;
  table.lowest = range.lowest;
  table.highest = range.highest;
  if (how.keep) how.keep(table);
  return table;
}

/// `points` are those of the tension.
LossTable Quadrature::make_table(double tension, const std::vector<Point>& points, const CurvatureRange& range,
                                 const Stop& stop) const {
  const SectionState state = {.axial_strain = tension / numbers_.EA, .EI_max = numbers_.EI_max};
  const std::optional<double> target = casefile::target_error(scene_);
  if (!target) {
    const casefile::QuadratureKeys& keys = keys_of(scene_).quadrature;
    const LossOptions options = {
        .steps = keys.steps, .knots_per_decade = keys.knots_per_decade, .tolerance = keys.tolerance, .stop = stop};
    return SectionalLoss(*law_, state, range, options).table();
  }
  TableAsk ask{.scene = scene_, .state = state, .range = range, .target = *target, .probes = {}};
  ask.stop = stop;
  section::Effort effort;
  for (const Point& point : some_of(losing(points, state, effort))) {
    const CurvatureRange chi = curvatures_of(scene_, numbers_, mass_, point);
    const double least = least_power(point.frequency, point.antinode_amplitude, mass_) / point.frequency;
    ask.probes.push_back({.curvature = chi.lowest, .least_loss = least});
    // Beside the clamps a mode is bent more than in its loops.
    if (goes_over_clamped_modes(scene_)) ask.probes.push_back({.curvature = chi.highest, .least_loss = least});
  }
  LossTable table = table_to_target(ask);
  table.evaluations += effort.evaluations;
  table.sweeps += effort.sweeps;
  table.error->section_evaluations += effort.evaluations;
  return table;
}

/// The points at which something slips: just above first slip errors are largest.
std::vector<Point> Quadrature::losing(const std::vector<Point>& points, const SectionState& state,
                                      section::Effort& effort) const {
  constexpr int steps = 8;
  std::vector<double> highest;
  for (const Point& point : points) highest.push_back(curvatures_of(scene_, numbers_, mass_, point).highest);
  const std::vector<double> losses = loss_per_cycle(*law_, state, highest, {.steps = steps}, effort);
  std::vector<Point> some;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (losses[i] > 1e-12 * state.EI_max * highest[i] * highest[i]) some.push_back(points[i]);
  }
  return some;
}

const Quadrature::Table& Quadrature::table_of(double tension) const {
  return *std::ranges::find(tables_, tension, &Table::tension);
}

const SectionalLoss& Quadrature::at_tension(double tension) const {
  return table_of(tension).loss;
}

Loop Quadrature::loop_at(const Point& point) const {
  return loop_by(at_tension(point.tension), point);
}

Loop Quadrature::loop_by(const SectionalLoss& loss, const Point& point) const {
  const Wave wave = wave_of(point, mass_);
  if (keys_of(scene_).mode_shape == casefile::ModeShape::string) return string_loop(wave);
  return stiff_loop(loss, wave);
}

bool Quadrature::wave_follows_frequency() const {
  return !goes_over_clamped_modes(scene_);
}

double Quadrature::free_span_curvature(const Point& point) const {
  if (!goes_over_clamped_modes(scene_)) return loop_at(point).curvature;
  return point.antinode_amplitude *
         curvature_of(clamped_mode_at(beam_of(scene_, numbers_, point.tension), point.frequency)).free_span;
}

double Quadrature::curvature_of_small_amplitude(const Point& point) const {
  constexpr double small = 1e-9;  // [m]
  Point still = point;
  still.antinode_amplitude = small;
  return free_span_curvature(still) / small;
}

double Quadrature::loss_at(double tension, double curvature) const {
  constexpr int places = 24;
  std::vector<double> amplitudes;
  for (int i = 0; i < places; ++i) {
    amplitudes.push_back(curvature * std::sin((i + 0.5) * std::numbers::pi / (2 * places)));
  }
  section::Effort effort;
  double sum = 0;
  for (double loss : loss_per_cycle(*law_, {.axial_strain = tension / numbers_.EA, .EI_max = numbers_.EI_max},
                                    amplitudes, {}, effort)) {
    sum += loss;
  }
  return sum / places;
}

PointResult Quadrature::at(const Point& point, const Watch&) const {
  const Table& table = table_of(point.tension);
  PointResult result = by_table(table.loss, table.material, point);
  result.error = table.error;
  result.chosen = table.chosen;
  return result;
}

PointResult Quadrature::by_table(const SectionalLoss& loss, const section::MaterialLoss& material,
                                 const Point& point) const {
  const double omega = 2 * std::numbers::pi * point.frequency;
  const double of_metal =
      section::loss_at(material, section::Component::bending2, omega) * std::numbers::pi * point.frequency;
  const air::AirForce air =
      surroundings_ ? air::force_at(surroundings_->air, surroundings_->diameter, point.frequency) : air::AirForce{};
  if (!goes_over_clamped_modes(scene_)) {
    const Loop loop = loop_by(loss, point);
    LossParts parts{.friction = point.frequency * mean_loss_of_sine(loss, loop.curvature),
                    .material = of_metal * loop.curvature * loop.curvature / 2,
                    .air = air.power_of_loop(omega * point.antinode_amplitude)};
    parts.material_free_span = parts.material;
    parts.air_free_span = parts.air;
    PointResult result{.self_damping = parts.self_damping(), .free_span = parts.self_damping(), .parts = parts};
    result.details.set("wavelength_m", 2 * std::numbers::pi / loop.wavenumber);
    result.details.set("wave_EI_N_m2", loop.EI);
    return result;
  }
  const ClampedMode mode = clamped_mode_at(beam_of(scene_, numbers_, point.tension), point.frequency);
  const SpanLoss lost = loss_of_mode(loss, mode, point.antinode_amplitude);
  const SpanLoss metal = mean_over_mode(mode, point.antinode_amplitude,
                                        [&](double curvature, double) { return of_metal * curvature * curvature; });
  const SpanLoss by_air = mean_over_mode(
      mode, point.antinode_amplitude, [&](double, double deflection) { return air.power_of_sine(omega * deflection); });
  const LossParts parts{.friction = point.frequency * lost.mean,
                        .material = metal.mean,
                        .air = by_air.mean,
                        .material_free_span = metal.free_span,
                        .air_free_span = by_air.free_span};
  PointResult result{.self_damping = parts.self_damping(), .parts = parts};
  if (lost.free_span) result.free_span = point.frequency * *lost.free_span + *metal.free_span;
  result.details.set("mode", mode.number);
  result.details.set("span_length_m", mode.beam.length);
  return result;
}

std::optional<PointChoice> Quadrature::first_choice(const Point&) const {
  const std::optional<double> target = casefile::target_error(scene_);
  return target ? std::optional(first_choice_of_table(scene_, *target)) : std::nullopt;
}

/// A table takes its steps of one and a half cycles for each of its knots, which are twice as many as it begins with,
/// or more; and the search for the onset, 65 points a round. To hold an accuracy takes coarser ones beside.
Expected Quadrature::expected(const std::vector<Point>& all) const {
  const std::vector<Point> points = points_of_quadrature(scene_, all);
  const casefile::QuadratureKeys& keys = keys_of(scene_).quadrature;
  const PointChoice choice = first_choice({}).value_or(PointChoice{});
  const double steps = choice.steps.value_or(keys.steps);
  const double knots = choice.knots_per_decade.value_or(keys.knots_per_decade);
  const double estimates = casefile::target_error(scene_) ? 2.2 : 1;
  Expected expected;
  for (const double tension : distinct_tensions(points)) {
    double lowest = INFINITY, highest = 0;
    for (const Point& point : points) {
      if (point.tension != tension) continue;
      const CurvatureRange chi = curvatures_of(scene_, numbers_, mass_, point);
      lowest = std::min(lowest, chi.lowest);
      highest = std::max(highest, chi.highest);
    }
    if (law_->name() == "stick" || law_->name() == "slip" || law_->name() == "elastic") {
      expected += {.least = 65, .most = 130};
      continue;
    }
    // The loops of contacts that give close in cycles.
    const double per_knot = estimates * steps * (scene_.section.law == casefile::Law::compliant ? 10 : 2.5);
    const double decades = std::log10(highest / lowest) + 1.5;
    expected += {.least = 1.25 * knots * decades * per_knot, .most = 8.3 * knots * decades * per_knot};
  }
  return expected;
}

}  // namespace strandyn::self_damping
