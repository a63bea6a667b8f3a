#include "strandyn/self_damping/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace strandyn::self_damping {

using casefile::DampingMethod;

namespace {

constexpr double agreed = 0.05;
/// Up to here above first slip a small difference of curvature is a large one of the loss.
constexpr double steep = 1.25;

/// The first of them at a point is what the others are held against.
constexpr std::array most_expensive_first = {DampingMethod::transient, DampingMethod::periodic,
                                             DampingMethod::quadrature, DampingMethod::foti_2018};

std::size_t rank(const PointRow& row) {
  const auto is_its = [&](DampingMethod method) { return row.method == name_of(method); };
  return static_cast<std::size_t>(std::ranges::find_if(most_expensive_first, is_its) - most_expensive_first.begin());
}

bool same_point(const PointRow& a, const PointRow& b) {
  const auto alike = [](double x, double y) { return std::abs(x - y) <= 1e-9 * y; };
  return alike(a.frequency, b.frequency) && alike(a.antinode_amplitude, b.antinode_amplitude) &&
         alike(a.tension, b.tension);
}

Point point_of(const PointRow& row) {
  return {.frequency = row.frequency, .antinode_amplitude = row.antinode_amplitude, .tension = row.tension};
}

/// A part of a ratio between two methods, with what it comes from.
struct Part {
  double RatioParts::*place;
  double factor = 1;
  std::string words;
};

/// Why the quadrature and the vibration of a whole span differ: the ratio is the product of these parts.
std::vector<Part> parts_of(const Quadrature& quadrature, const PointRow& row, const SpanVibration& span, double ratio) {
  const Point point = point_of(row);
  // A clamped mode of the span's length keeps its shape at any frequency; a wave has another length at the resonance.
  Point at_resonance = point;
  if (quadrature.wave_follows_frequency()) at_resonance.frequency = span.resonance;
  const double resonance = span.resonance / point.frequency;
  const double of_mode = quadrature.free_span_curvature(at_resonance);
  const double measured = *span.free_span_curvature;
  const double at_mode = quadrature.loss_at(point.tension, of_mode);
  const double at_asked = quadrature.loss_at(point.tension, quadrature.free_span_curvature(point));
  const double at_measured = quadrature.loss_at(point.tension, measured);
  const double at_tension = quadrature.loss_at(span.mean_tension, measured);
  if (at_mode <= 0 || at_measured <= 0 || at_tension <= 0) return {};
  std::vector<Part> parts = {
      {.place = &RatioParts::frequency,
       .factor = at_asked / at_mode / resonance,
       .words = fmt::format("the span resonates at {:.4f} of the frequency that was asked for, as with a bending "
                            "stiffness of {:.3f} EI_max",
                            resonance, span.effective_EI)},
      {.place = &RatioParts::curvature,
       .factor = at_mode / at_measured,
       .words = fmt::format("the curvature of the free span is {:.4f} of the mode's", measured / of_mode)},
      {.place = &RatioParts::tension,
       .factor = at_measured / at_tension,
       .words = fmt::format("the vibration stretches the span: the mean tension is {:.4f} of that at rest, the highest "
                            "{:.4f}, and raises the friction limits",
                            span.mean_tension / point.tension, span.highest_tension / point.tension)}};
  Part rest{
      .place = &RatioParts::rest,
      .factor = ratio,
      .words = fmt::format("the curvature is no sine along the span or in time, it reaches {:.3f} of one of the same "
                           "mean square: sections that slip are softer, and send out waves of higher harmonics",
                           *span.highest_curvature / measured)};
  for (const Part& part : parts) rest.factor /= part.factor;
  parts.push_back(rest);
  return parts;
}

/// What the parts are, and in words the ones that make the difference.
void explain(const std::vector<Part>& parts, bool wanted, ComparisonRow& entry) {
  if (parts.empty()) return;
  double largest = 0;
  entry.parts.emplace();
  for (const Part& part : parts) {
    (*entry.parts).*part.place = part.factor;
    largest = std::max(largest, std::abs(std::log(part.factor)));
  }
  if (!wanted) return;
  std::string why;
  if (entry.curvature_over_first_slip && *entry.curvature_over_first_slip < steep) {
    why = fmt::format("the curvature is only {:.3f} of that of first slip, from where the loss rises steeply",
                      *entry.curvature_over_first_slip);
  }
  for (const Part& part : parts) {
    if (std::abs(std::log(part.factor)) < 0.5 * largest) continue;
    why += fmt::format("{}{} ({:+.1f} %)", why.empty() ? "" : "; ", part.words, 100 * (part.factor - 1));
  }
  entry.why = why;
}

std::optional<double> ratio_of(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b && *b != 0 ? std::optional(*a / *b) : std::nullopt;
}

ComparisonRow compare(const Quadrature& quadrature, const PointRow& row, const PointRow& reference) {
  ComparisonRow entry{.frequency = row.frequency,
                      .antinode_amplitude = row.antinode_amplitude,
                      .tension = row.tension,
                      .method = row.method,
                      .reference = reference.method,
                      .span_ratio = ratio_of(row.self_damping, reference.self_damping),
                      .free_span_ratio = ratio_of(row.free_span, reference.free_span)};
  if (!entry.free_span_ratio) {
    if (row.free_span && reference.free_span) {
      entry.agrees = *row.free_span == 0;
      entry.why = *entry.agrees ? "nothing slips in the free span by either method"
                                : fmt::format("the free span slips by {} only", row.method);
    }
    return entry;
  }
  const double free = *entry.free_span_ratio;
  entry.agrees = std::abs(free - 1) <= agreed;
  const bool measured = row.method == name_of(DampingMethod::quadrature) && reference.vibration &&
                        reference.vibration->free_span_curvature && free > 0;
  const double onset = quadrature.at_tension(row.tension).onset();
  if (measured && onset > 0) {
    entry.curvature_over_first_slip = quadrature.free_span_curvature(point_of(row)) / onset;
  }
  if (measured) {
    explain(parts_of(quadrature, row, *reference.vibration, free), !*entry.agrees, entry);
    if (entry.parts && quadrature.wave_follows_frequency()) {
      entry.free_span_ratio_at_resonance = free / entry.parts->frequency;
    }
  } else if (!*entry.agrees && free == 0) {
    entry.why = fmt::format("the free span slips by {} only", reference.method);
  }
  return entry;
}

}  // namespace

Comparison compare_methods(const Quadrature& quadrature, const std::vector<PointRow>& points) {
  Comparison comparison;
  // The methods that are worth comparing with are few; most points have the one method of the grid.
  std::vector<const PointRow*> finished;
  for (const PointRow& row : points) {
    if (row.has_numbers()) finished.push_back(&row);
  }
  std::ranges::stable_sort(finished, {}, [](const PointRow* row) { return rank(*row); });
  const auto first_of_last_rank =
      std::ranges::find_if(finished, [&](const PointRow* row) { return rank(*row) == rank(*finished.back()); });
  const std::span<const PointRow* const> references(finished.begin(), first_of_last_rank);
  std::size_t judged = 0, apart = 0;
  for (const PointRow& row : points) {
    if (!row.has_numbers()) continue;
    const auto serves = [&](const PointRow* other) { return rank(*other) < rank(row) && same_point(row, *other); };
    const auto reference = std::ranges::find_if(references, serves);
    if (reference == references.end()) continue;
    const ComparisonRow& entry = comparison.rows.emplace_back(compare(quadrature, row, **reference));
    if (!entry.agrees) continue;
    ++judged;
    apart += *entry.agrees ? 0 : 1;
  }
  if (apart > 0) {
    comparison.warning = fmt::format(
        "at {} of {} points two methods differ by more than {:.0f} % in the free span; `comparisons` says why", apart,
        judged, 100 * agreed);
  }
  return comparison;
}

}  // namespace strandyn::self_damping
