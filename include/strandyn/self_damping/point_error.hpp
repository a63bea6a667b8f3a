#pragma once
/// \file Where a case asks for an accuracy: what a point is off by, and what was chosen for it.
///
/// The error is that of the self-damping, as a part of it or of what a loss of 1e-4 of the energy in each cycle would
/// take, where that is more: f 1e-4 m V^2/4.

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include "strandyn/results/record.hpp"

namespace strandyn::self_damping {

/// [W/m] what errors are compared with at least. Frequency [Hz], antinode amplitude [m], mass per length [kg/m].
inline double least_power(double frequency, double amplitude, double mass) {
  constexpr double least_loss = 1e-4;
  const double velocity = 2 * std::numbers::pi * frequency * amplitude;
  return frequency * least_loss * mass * velocity * velocity / 4;
}

/// The parts of an error [-], added up; those that a method has. Empty too where a part could not be estimated: then
/// the sum is empty as well.
struct PointError {
  std::optional<double> relative{};
  std::optional<double> mesh{}, harmonics{}, samples{}, steps{}, table{}, time{}, points{}, amplitude{};
  std::uint64_t section_evaluations = 0;

  bool is_below(double target) const { return relative && *relative <= target; }
};
template <class V>
void members(V& v, PointError& e) {
  v.value("relative", e.relative,
          {.what = "of the self-damping: the sum of the parts; absent where one of them could not be estimated",
           .shown = "estimated error"});
  v.value("mesh", e.mesh, {.what = "by the elements of the span"});
  v.value("harmonics", e.harmonics, {.what = "by the harmonics of the motion"});
  v.value("samples", e.samples, {.what = "by the samples of a cycle"});
  v.value("steps", e.steps, {.what = "by the steps in which a section is bent"});
  v.value("table", e.table, {.what = "by the amplitudes at which the loss of a section is tabulated"});
  v.value("time", e.time, {.what = "by the steps of the integration"});
  v.value("points", e.points, {.what = "by the points of a section; absent where no wires slip"});
  v.value("amplitude", e.amplitude, {.what = "by how near a test bench came to the amplitude"});
  v.value("section_evaluations", e.section_evaluations, {.what = "that the estimate took, among those of `cost`"});
}

/// What was chosen, by key of the case.
struct PointChoice {
  std::optional<int> elements{}, harmonics{}, samples{};
  std::optional<int> steps{}, knots_per_decade{};
  std::optional<double> tolerance{};
  std::optional<std::string> method{};
  std::optional<int> steps_per_cycle{};
  std::optional<double> amplitude_tolerance{};
  std::optional<int> points{};
};
template <class V>
void members(V& v, PointChoice& c) {
  v.value("elements", c.elements, {.what = "span.elements"});
  v.value("harmonics", c.harmonics, {.what = "analysis.periodic.harmonics"});
  v.value("samples", c.samples, {.what = "analysis.periodic.samples"});
  v.value("steps", c.steps, {.what = "analysis.quadrature.steps"});
  v.value("knots_per_decade", c.knots_per_decade, {.what = "analysis.quadrature.knots_per_decade"});
  v.value("tolerance", c.tolerance, {.what = "analysis.quadrature.tolerance"});
  v.value("method", c.method, {.what = "integrator.method"});
  v.value("steps_per_cycle", c.steps_per_cycle, {.what = "integrator.steps_per_cycle"});
  v.value("amplitude_tolerance", c.amplitude_tolerance, {.what = "analysis.bench.amplitude_tolerance"});
  v.value("points", c.points, {.what = "section.points"});
}

}  // namespace strandyn::self_damping
