#include <algorithm>
#include <cmath>
#include <numbers>

#include "self_damping_parts.hpp"
#include "self_damping_periodic.hpp"
#include "side_by_side.hpp"
#include "strandyn/analysis/wind_power.hpp"
#include "strandyn/exact/foti_2018.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/study/mode_loss.hpp"

namespace strandyn::study {

using casefile::DampingRoad;
using casefile::Scene;

namespace {

/// [1/m] amplitude of the curvature of a taut string.
double string_curvature(double mass, const Point& point) {
  const double omega = 2 * std::numbers::pi * point.frequency;
  return mass * omega * omega * point.antinode_amplitude / point.tension;
}

bool goes_over_clamped_modes(const Scene& scene) {
  return scene.analysis.self_damping.mode_shape == casefile::ModeShape::clamped;
}

exact::TensionedBeam beam_of(const Scene& scene, const build::SectionNumbers& numbers, double tension) {
  return {.tension = tension,
          .EI = numbers.EI_max,
          .mass_per_length = *casefile::mass_per_length(scene),
          .length = *scene.span->length};
}

/// The points whose sectional loss will be asked for: those of the road, and the ends of every energy balance.
std::vector<Point> points_of_quadrature(const Scene& scene, const std::vector<Point>& all) {
  const casefile::SelfDampingAnalysis& a = scene.analysis.self_damping;
  const double diameter = build::section_numbers(scene).diameter;
  std::vector<Point> points;
  std::ranges::copy_if(all, std::back_inserter(points),
                       [](const Point& point) { return point.road == DampingRoad::quadrature; });
  for (const casefile::EnergyBalanceKeys& balance : a.energy_balances) {
    if (balance.self_damping != casefile::BalancedBy::quadrature) continue;
    for (double tension : distinct_tensions(all)) {
      for (double frequency : balance.frequencies.empty() ? a.frequencies : balance.frequencies) {
        for (const analysis::WindPowerCurve* curve : analysis::wind_power_curves()) {
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

bool needs_quadrature(const casefile::SelfDampingAnalysis& analysis) {
  return analysis.takes(DampingRoad::quadrature) ||
         std::ranges::any_of(analysis.energy_balances, [](const casefile::EnergyBalanceKeys& balance) {
           return balance.self_damping == casefile::BalancedBy::quadrature;
         });
}

Quadrature::Quadrature(const Scene& scene, const std::vector<Point>& all)
    : scene_(scene), numbers_(build::section_numbers(scene)), mass_(*casefile::mass_per_length(scene)) {
  const std::vector<Point> points = points_of_quadrature(scene, all);
  const auto law = build::build_law(scene_, section::Dimension::planar);
  const std::vector<double> tensions = distinct_tensions(points);
  std::vector<std::optional<SectionalLoss>> losses(tensions.size());
  side_by_side(tensions.size(), [&](std::size_t i) {
    CurvatureRange range{.lowest = INFINITY, .highest = 0};
    for (const Point& point : points) {
      if (point.tension != tensions[i]) continue;
      ClampedCurvature chi{.free_span = string_curvature(mass_, point), .largest = string_curvature(mass_, point)};
      if (goes_over_clamped_modes(scene_)) {
        chi = curvature_of(clamped_mode_at(beam_of(scene_, numbers_, point.tension), point.frequency));
        chi.free_span *= point.antinode_amplitude;
        chi.largest *= point.antinode_amplitude;
      }
      range.lowest = std::min(range.lowest, chi.free_span);
      range.highest = std::max(range.highest, chi.largest);
    }
    const SectionState state = {.axial_strain = tensions[i] / numbers_.EA, .EI_max = numbers_.EI_max};
    losses[i].emplace(*law, state, range);
  });
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    tables_.push_back({.tension = tensions[i], .loss = std::move(*losses[i])});
  }
}

const SectionalLoss& Quadrature::at_tension(double tension) const {
  return std::ranges::find(tables_, tension, &Table::tension)->loss;
}

double Quadrature::free_span_curvature(const Point& point) const {
  if (!goes_over_clamped_modes(scene_)) return string_curvature(mass_, point);
  return point.antinode_amplitude *
         curvature_of(clamped_mode_at(beam_of(scene_, numbers_, point.tension), point.frequency)).free_span;
}

double Quadrature::loss_at(double tension, double curvature) const {
  constexpr int places = 24;
  std::vector<double> amplitudes;
  for (int i = 0; i < places; ++i) {
    amplitudes.push_back(curvature * std::sin((i + 0.5) * std::numbers::pi / (2 * places)));
  }
  const auto law = build::build_law(scene_, section::Dimension::planar);
  section::Effort effort;
  double sum = 0;
  for (double loss : loss_per_cycle(*law, {.axial_strain = tension / numbers_.EA, .EI_max = numbers_.EI_max},
                                    amplitudes, {}, effort)) {
    sum += loss;
  }
  return sum / places;
}

PointResult Quadrature::operator()(const Point& point) const {
  const SectionalLoss& loss = at_tension(point.tension);
  if (!goes_over_clamped_modes(scene_)) {
    const double power = point.frequency * mean_loss_of_sine(loss, string_curvature(mass_, point));
    return {.self_damping = power, .free_span = power};
  }
  const ClampedMode mode = clamped_mode_at(beam_of(scene_, numbers_, point.tension), point.frequency);
  const SpanLoss lost = loss_of_mode(loss, mode, point.antinode_amplitude);
  PointResult result{.self_damping = point.frequency * lost.mean};
  if (lost.free_span) result.free_span = point.frequency * *lost.free_span;
  result.details = {{"mode", mode.number}, {"span_length_m", mode.beam.length}};
  return result;
}

Road simplified_road(const Scene& scene) {
  const casefile::SimplifiedLoss& given = scene.analysis.self_damping.simplified;
  const build::SectionNumbers numbers = build::section_numbers(scene);
  const double mass = *casefile::mass_per_length(scene);
  return [&scene, &given, numbers, mass](const Point& point) -> PointResult {
    exact::Foti2018 conductor = {.EI = given.EI.value_or(numbers.EI_max - numbers.EI_min),
                                 .chi_0 = 0,
                                 .mass_per_length = mass,
                                 .tension = point.tension};
    conductor.chi_0 = given.chi_0_at_rated_strength
                          ? *given.chi_0_at_rated_strength * point.tension / scene.conductor->strand.rated_strength
                          : exact::full_slip(scene.conductor->strand, point.tension).chi_0;
    if (conductor.chi_0 == 0) return {.self_damping = 0, .free_span = 0};  // no friction
    const double power =
        exact::self_damping(conductor, {.antinode_amplitude = point.antinode_amplitude, .frequency = point.frequency});
    return {.self_damping = power, .free_span = power};
  };
}

Road make_road(DampingRoad road, const RoadContext& context) {
  switch (road) {
    case DampingRoad::quadrature:
      return [quadrature = context.quadrature](const Point& point) { return (*quadrature)(point); };
    case DampingRoad::foti_2018:
      return simplified_road(context.scene);
    case DampingRoad::periodic:
      return periodic_road(context);
    case DampingRoad::transient:
      break;
  }
  return transient_road(context);
}

}  // namespace strandyn::study
