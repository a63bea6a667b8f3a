// Points that were reached by several roads, side by side.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "self_damping_parts.hpp"

namespace strandyn::study {

using casefile::DampingRoad;
using json = nlohmann::ordered_json;

namespace {

constexpr double agreed = 0.05;
/// Up to here above first slip a small difference of curvature is a large one of the loss.
constexpr double steep = 1.25;
constexpr const char* free_span = "self_damping_free_span_W_per_m";

/// From the dearest road to the cheapest: the first of them at a point is what the others are held against.
constexpr std::array dearest_first = {DampingRoad::transient, DampingRoad::periodic, DampingRoad::quadrature,
                                      DampingRoad::foti_2018};

std::size_t rank(const json& row) {
  std::size_t i = 0;
  while (i < dearest_first.size() && row["road"] != casefile::name_of(dearest_first[i])) ++i;
  return i;
}

bool same_point(const json& a, const json& b) {
  return std::ranges::all_of(std::array{"frequency_Hz", "antinode_amplitude_m", "tension_N"}, [&](const char* key) {
    const double x = a[key], y = b[key];
    return std::abs(x - y) <= 1e-9 * y;
  });
}

/// A part of a ratio between two roads, with what it comes from.
struct Part {
  const char* name;
  double factor = 1;
  std::string words;
};

/// Why the quadrature and the vibration of a whole span differ: the ratio is the product of these parts.
std::vector<Part> parts_of(const Quadrature& quadrature, const json& row, const json& span, double ratio) {
  const Point point = {
      .frequency = row["frequency_Hz"], .antinode_amplitude = row["antinode_amplitude_m"], .tension = row["tension_N"]};
  const double resonance = span["resonance_Hz"].get<double>() / point.frequency;
  const double of_mode = quadrature.free_span_curvature(point);
  const double measured = span["free_span_curvature_per_m"];
  const double mean_tension = span["mean_tension_N"];
  const double at_mode = quadrature.loss_at(point.tension, of_mode);
  const double at_measured = quadrature.loss_at(point.tension, measured);
  const double at_tension = quadrature.loss_at(mean_tension, measured);
  if (at_mode <= 0 || at_measured <= 0 || at_tension <= 0) return {};
  std::vector<Part> parts = {
      {.name = "frequency",
       .factor = 1 / resonance,
       .words = fmt::format("the span resonates at {:.4f} of the frequency that was asked for, as with a bending "
                            "stiffness of {:.3f} EI_max",
                            resonance, span["effective_EI_over_EI_max"].get<double>())},
      {.name = "curvature",
       .factor = at_mode / at_measured,
       .words = fmt::format("the curvature of the free span is {:.4f} of the mode's", measured / of_mode)},
      {.name = "tension",
       .factor = at_measured / at_tension,
       .words = fmt::format("the vibration stretches the span: the mean tension is {:.4f} of that at rest, the highest "
                            "{:.4f}, and raises the friction limits",
                            mean_tension / point.tension, span["highest_tension_N"].get<double>() / point.tension)}};
  Part rest{
      .name = "rest",
      .factor = ratio,
      .words = fmt::format("the curvature is no sine along the span or in time, it reaches {:.3f} of one of the same "
                           "mean square: sections that slip are softer, and send out waves of higher harmonics",
                           span["highest_curvature_per_m"].get<double>() / measured)};
  for (const Part& part : parts) rest.factor /= part.factor;
  parts.push_back(rest);
  return parts;
}

/// What the parts are, and in words the ones that make the difference.
void explain(const std::vector<Part>& parts, bool wanted, json& entry) {
  if (parts.empty()) return;
  double largest = 0;
  for (const Part& part : parts) {
    entry["parts"][part.name] = part.factor;
    largest = std::max(largest, std::abs(std::log(part.factor)));
  }
  if (!wanted) return;
  std::string why;
  if (entry.contains("curvature_over_first_slip") && entry["curvature_over_first_slip"] < steep) {
    why = fmt::format("the curvature is only {:.3f} of that of first slip, from where the loss rises steeply",
                      entry["curvature_over_first_slip"].get<double>());
  }
  for (const Part& part : parts) {
    if (std::abs(std::log(part.factor)) < 0.5 * largest) continue;
    why += fmt::format("{}{} ({:+.1f} %)", why.empty() ? "" : "; ", part.words, 100 * (part.factor - 1));
  }
  entry["why"] = why;
}

json compare(const Quadrature& quadrature, const json& row, const json& reference) {
  json entry = {{"frequency_Hz", row["frequency_Hz"]},
                {"antinode_amplitude_m", row["antinode_amplitude_m"]},
                {"tension_N", row["tension_N"]},
                {"road", row["road"]},
                {"reference", reference["road"]}};
  const auto ratio = [&](const char* key) -> std::optional<double> {
    if (!row.contains(key) || !reference.contains(key) || reference[key] == 0.0) return std::nullopt;
    return row[key].get<double>() / reference[key].get<double>();
  };
  if (const auto span = ratio("self_damping_W_per_m")) entry["span_ratio"] = *span;
  const auto free = ratio(free_span);
  if (!free) {
    if (row.contains(free_span) && reference.contains(free_span)) {
      const bool both = row[free_span] == 0.0;
      entry["agrees"] = both;
      entry["why"] = both ? "nothing slips in the free span on either road"
                          : fmt::format("the free span slips by {} only", row["road"].get<std::string>());
    }
    return entry;
  }
  entry["free_span_ratio"] = *free;
  const bool agrees = std::abs(*free - 1) <= agreed;
  entry["agrees"] = agrees;
  const bool measured = row["road"] == casefile::name_of(DampingRoad::quadrature) &&
                        reference.contains("free_span_curvature_per_m") && *free > 0;
  const double onset = quadrature.at_tension(row["tension_N"]).onset();
  if (measured && onset > 0) {
    entry["curvature_over_first_slip"] =
        quadrature.free_span_curvature({.frequency = row["frequency_Hz"],
                                        .antinode_amplitude = row["antinode_amplitude_m"],
                                        .tension = row["tension_N"]}) /
        onset;
  }
  if (measured) {
    explain(parts_of(quadrature, row, reference, *free), !agrees, entry);
  } else if (!agrees && *free == 0) {
    entry["why"] = fmt::format("the free span slips by {} only", reference["road"].get<std::string>());
  }
  return entry;
}

}  // namespace

void add_road_comparison(const Quadrature& quadrature, json& summary) {
  const json& points = summary["points"];
  json list = json::array();
  std::size_t judged = 0, apart = 0;
  // The roads that are worth comparing with are few; most points have the one road of the grid.
  std::vector<const json*> finished;
  for (const json& row : points) {
    if (!row.contains("failed")) finished.push_back(&row);
  }
  std::ranges::stable_sort(finished, {}, [](const json* row) { return rank(*row); });
  const auto first_of_last_rank =
      std::ranges::find_if(finished, [&](const json* row) { return rank(*row) == rank(*finished.back()); });
  const std::span<const json* const> references(finished.begin(), first_of_last_rank);
  for (const json& row : points) {
    if (row.contains("failed") || references.empty()) continue;
    const json* reference = nullptr;
    for (const json* other : references) {
      if (rank(*other) >= rank(row)) break;
      if (!same_point(row, *other)) continue;
      reference = other;
      break;
    }
    if (!reference) continue;
    list.push_back(compare(quadrature, row, *reference));
    if (!list.back().contains("agrees")) continue;
    ++judged;
    apart += list.back()["agrees"] == true ? 0 : 1;
  }
  if (list.empty()) return;
  summary["roads"] = list;
  if (apart == 0) return;
  summary["warnings"].push_back(
      fmt::format("at {} of {} points two roads differ by more than {:.0f} % in the free span; `roads` says why", apart,
                  judged, 100 * agreed));
}

}  // namespace strandyn::study
