#pragma once
/// \file Points that were reached by several methods, each beside the most expensive of them, and what is behind a
/// difference of the free span.

#include "strandyn/self_damping/quadrature.hpp"

namespace strandyn::self_damping {

/// A ratio of quadrature to vibration as a product of what it comes from.
struct RatioParts {
  double frequency = 1, curvature = 1, tension = 1, rest = 1;
};
template <class V>
void members(V& v, RatioParts& p) {
  v.value("frequency", p.frequency,
          {.what = "the span resonates beside the frequency that was asked for: over a sine its wave is longer, too"});
  v.value("curvature", p.curvature, {.what = "the curvature of the free span is not that of the mode"});
  v.value("tension", p.tension, {.what = "the vibration stretches the span"});
  v.value("rest", p.rest, {.what = "the curvature is no sine along the span or in time"});
}

struct ComparisonRow {
  double frequency = 0, antinode_amplitude = 0, tension = 0;
  std::string method, reference;
  std::optional<double> span_ratio{}, free_span_ratio{}, free_span_ratio_at_resonance{};
  std::optional<bool> agrees{};
  std::optional<double> curvature_over_first_slip{};
  std::optional<RatioParts> parts{};
  std::optional<std::string> why{};
};
template <class V>
void members(V& v, ComparisonRow& c) {
  v.value("frequency_Hz", c.frequency, {.what = "of the point"});
  v.value("antinode_amplitude_m", c.antinode_amplitude, {.what = "of the point"});
  v.value("tension_N", c.tension, {.what = "of the point"});
  v.value("method", c.method, {.what = "the method that is compared"});
  v.value("reference", c.reference, {.what = "with this one, the most expensive at the point"});
  v.value("span_ratio", c.span_ratio, {.what = "of their self-damping, whole span"});
  v.value("free_span_ratio", c.free_span_ratio, {.what = "the same without the end loops"});
  v.value("free_span_ratio_at_resonance", c.free_span_ratio_at_resonance,
          {.what = "with the wave of the quadrature at the frequency at which the span resonates"});
  v.value("agrees", c.agrees, {.what = "within 5 % in the free span"});
  v.value("curvature_over_first_slip", c.curvature_over_first_slip, {.what = "of the free span"});
  v.record("parts", c.parts, {.what = "the factors whose product is the ratio"});
  v.value("why", c.why, {.what = "what makes the difference, in words"});
}

struct Comparison {
  std::vector<ComparisonRow> rows;
  std::optional<std::string> warning{};  ///< where methods differ by more than a twentieth
};
Comparison compare_methods(const Quadrature& quadrature, const std::vector<PointRow>& points);

}  // namespace strandyn::self_damping
