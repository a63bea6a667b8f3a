#include <algorithm>
#include <numbers>

#include "strandyn/build/section_law.hpp"
#include "strandyn/exact/taut_string.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/self_damping/method.hpp"

namespace strandyn::self_damping {

using casefile::Scene;

namespace {

/// [Hz] of a mode of the span: the string's where the quadrature goes over that, the beam's with all wires sticking
/// else, between pins where the quadrature goes over a sine; clamped where the quadrature goes over clamped modes, or
/// where the span is.
double mode_frequency(const Scene& scene, casefile::DampingMethod method, double tension, int mode) {
  const double mass = *casefile::mass_per_length(scene);
  const double length = *scene.span->length;
  const casefile::ModeShape shape = scene.as<casefile::SelfDampingAnalysis>().mode_shape;
  const bool by_quadrature = method == casefile::DampingMethod::quadrature;
  const bool string =
      method == casefile::DampingMethod::foti_2018 || (by_quadrature && shape == casefile::ModeShape::string);
  if (string) return exact::frequency({.tension = tension, .mass_per_length = mass, .length = length}, mode);
  const exact::TensionedBeam beam = {
      .tension = tension, .EI = build::section_numbers(scene).EI_max, .mass_per_length = mass, .length = length};
  const bool pins = scene.span->left == casefile::Support::pinned && scene.span->right == casefile::Support::pinned;
  const bool pinned = by_quadrature ? shape == casefile::ModeShape::sine : pins;
  const exact::BeamEnds ends = pinned ? exact::BeamEnds::pinned : exact::BeamEnds::clamped;
  return exact::TensionedBeamMode(beam, ends, mode).frequency();
}

struct Asked {
  casefile::DampingAt at;
  const char* grid = nullptr;
};

/// The grid as single points, in its order: amplitudes, then velocities.
std::vector<Asked> single_points(const Scene& scene) {
  const casefile::SelfDampingAnalysis& a = scene.as<casefile::SelfDampingAnalysis>();
  std::vector<casefile::DampingAt> tensions, frequencies, amplitudes;
  std::vector<Asked> all;
  for (double part : a.tensions_rts) tensions.emplace_back().tension_rts = part;
  for (double tension : a.tensions) tensions.emplace_back().tension = tension;
  for (double frequency : a.frequencies) frequencies.emplace_back().frequency = frequency;
  for (double mode : a.modes) frequencies.emplace_back().mode = static_cast<int>(mode);
  for (double part : a.amplitudes_over_diameter) amplitudes.emplace_back().amplitude_over_diameter = part;
  for (double amplitude : a.antinode_amplitudes) amplitudes.emplace_back().antinode_amplitude = amplitude;
  for (double velocity : a.antinode_velocities) amplitudes.emplace_back().antinode_velocity = velocity;
  for (const casefile::DampingAt& tension : tensions) {
    for (const casefile::DampingAt& frequency : frequencies) {
      for (casefile::DampingAt point : amplitudes) {
        point.tension = tension.tension;
        point.tension_rts = tension.tension_rts;
        point.frequency = frequency.frequency;
        point.mode = frequency.mode;
        all.push_back({.at = point, .grid = point.antinode_velocity ? velocity_grid : amplitude_grid});
      }
    }
  }
  for (const casefile::DampingAt& at : a.at) all.push_back({.at = at});
  return all;
}

}  // namespace

std::vector<Point> points_of(const Scene& scene) {
  const double diameter = build::section_numbers(scene).diameter;
  std::vector<Point> points;
  const auto& keys = scene.as<casefile::SelfDampingAnalysis>();
  for (const auto& [at, grid] : single_points(scene)) {
    Point point{.method = at.method.value_or(keys.method), .mode = at.mode, .grid = grid};
    point.tension = at.tension ? *at.tension : *at.tension_rts * scene.conductor->strand.rated_strength;
    point.frequency = at.frequency ? *at.frequency : mode_frequency(scene, point.method, point.tension, *at.mode);
    point.antinode_amplitude = at.antinode_amplitude ? *at.antinode_amplitude
                               : at.amplitude_over_diameter
                                   ? *at.amplitude_over_diameter * diameter
                                   : *at.antinode_velocity / (2 * std::numbers::pi * point.frequency);
    const bool cut = grid && at.antinode_velocity && keys.highest_amplitude_over_diameter;
    if (cut && point.antinode_amplitude > *keys.highest_amplitude_over_diameter * diameter * (1 + 1e-9)) continue;
    points.push_back(point);
  }
  return points;
}

std::vector<double> distinct_tensions(const std::vector<Point>& points) {
  std::vector<double> tensions;
  for (const Point& point : points) {
    if (std::ranges::find(tensions, point.tension) == tensions.end()) tensions.push_back(point.tension);
  }
  return tensions;
}

}  // namespace strandyn::self_damping
