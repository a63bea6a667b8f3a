#include <algorithm>
#include <cmath>
#include <numbers>

#include "self_damping_parts.hpp"
#include "strandyn/analysis/published_laws.hpp"
#include "strandyn/study/mode_loss.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

json interval_json(const analysis::Interval& interval) {
  return json::array({interval.low, interval.high});
}

void add_estimate(json& out, const std::string& name, const std::optional<analysis::Estimate>& estimate) {
  if (!estimate) return;
  out[name] = estimate->value;
  if (estimate->standard_error) out[name + "_standard_error"] = *estimate->standard_error;
  if (estimate->interval_95) out[name + "_interval_95"] = interval_json(*estimate->interval_95);
}

void add_optional(json& out, const char* name, const std::optional<double>& value) {
  if (value) out[name] = *value;
}

/// Points over a published law: the least, the geometric mean, the largest ratio.
json level_json(const analysis::PowerLaw& law, const std::vector<analysis::SelfDampingPoint>& points) {
  double least = 0, largest = 0, sum = 0;
  std::size_t count = 0;
  for (const analysis::SelfDampingPoint& point : points) {
    if (point.power <= 0) continue;
    const double ratio = point.power / analysis::power(law, point.at);
    least = count == 0 ? ratio : std::min(least, ratio);
    largest = std::max(largest, ratio);
    sum += std::log(ratio);
    ++count;
  }
  if (count == 0) return nullptr;
  return {{"least", least}, {"mean", std::exp(sum / static_cast<double>(count))}, {"largest", largest}};
}

/// The published exponents, how far the fit lies outside of their band, and the levels where a factor is known.
json published_json(const Scene& scene, const analysis::PowerLawFit& fit,
                    const std::vector<analysis::SelfDampingPoint>& points) {
  const analysis::ExponentBands bands = analysis::published_bands();
  const analysis::BandComparison comparison = analysis::compare_with_published(fit);
  json outside = json::object();
  add_optional(outside, "l", comparison.amplitude);
  add_optional(outside, "m", comparison.frequency);
  add_optional(outside, "n", comparison.tension);
  json laws = json::array();
  for (const analysis::PublishedLaw& law : analysis::published_laws()) {
    json entry = {{"name", law.name}, {"l", interval_json(law.amplitude)}, {"m", interval_json(law.frequency)}};
    if (law.tension) entry["n"] = interval_json(*law.tension);
    if (scene.conductor && scene.conductor->strand.rated_strength > 0) {
      const auto full = analysis::law_for(law, {.diameter = scene.conductor->strand.outer_diameter(),
                                                .mass_per_length = *casefile::mass_per_length(scene),
                                                .rated_strength = scene.conductor->strand.rated_strength});
      if (full) {
        entry["k"] = full->factor;
        const json level = level_json(*full, points);
        if (!level.is_null()) entry["points_over_law"] = level;
      }
    }
    laws.push_back(entry);
  }
  return {{"source", analysis::published_laws_source},
          {"l", interval_json(bands.amplitude)},
          {"m", interval_json(bands.frequency)},
          {"n", interval_json(bands.tension)},
          {"fit_outside_by", outside},
          {"laws", laws}};
}

}  // namespace

std::optional<json> compute_row(const Scene& scene, const Road& road, const Point& point) {
  PointResult result;
  try {
    result = road(point);
  } catch (const ComputationError& error) {
    result.failure = error.what();
  }
  if (result.stopped) return std::nullopt;
  json row = {{"frequency_Hz", point.frequency},
              {"antinode_amplitude_m", point.antinode_amplitude},
              {"tension_N", point.tension},
              {"road", casefile::name_of(point.road)}};
  if (scene.conductor) {
    row["amplitude_over_diameter"] = point.antinode_amplitude / scene.conductor->strand.outer_diameter();
  }
  if (result.effort.evaluations > 0) {
    row["section_evaluations"] = result.effort.evaluations;
    row["section_sweeps"] = result.effort.sweeps;
  }
  if (!result.failure.empty()) {
    row["failed"] = result.failure;
    return row;
  }
  row["self_damping_W_per_m"] = result.self_damping;
  if (result.free_span) row["self_damping_free_span_W_per_m"] = *result.free_span;
  for (const auto& [key, value] : result.details.items()) row[key] = value;
  return row;
}

std::vector<analysis::SelfDampingPoint> points_to_fit(const json& rows, casefile::DampingRoad road, DampingOf what) {
  const char* key = what == DampingOf::whole_span ? "self_damping_W_per_m" : "self_damping_free_span_W_per_m";
  std::vector<analysis::SelfDampingPoint> points;
  for (const json& row : rows) {
    if (row["road"] != casefile::name_of(road) || !row.contains(key)) continue;
    points.push_back({.at = {.antinode_amplitude = row["antinode_amplitude_m"],
                             .frequency = row["frequency_Hz"],
                             .tension = row["tension_N"]},
                      .power = row[key]});
  }
  return points;
}

json fit_json(const analysis::PowerLawFit& fit) {
  json out = json::object();
  if (const auto law = fit.law()) {
    out["k"] = law->factor;
    if (fit.log_factor->interval_95) {
      const analysis::Interval& log_k = *fit.log_factor->interval_95;
      out["k_interval_95"] = {std::exp(log_k.low), std::exp(log_k.high)};
    }
  }
  add_estimate(out, "l", fit.amplitude);
  add_estimate(out, "m", fit.frequency);
  add_estimate(out, "n", fit.tension);
  add_optional(out, "r2", fit.r_squared);
  out["scatter"] = fit.scatter;
  out["points"] = fit.points;
  out["points_without_loss"] = fit.without_loss;
  add_optional(out, "no_slip_below_m", fit.no_slip_below);
  return out;
}

std::optional<analysis::PowerLaw> add_fits(const Scene& scene, json& summary) {
  const casefile::SelfDampingAnalysis& a = scene.analysis.self_damping;
  const auto whole = points_to_fit(summary["points"], a.road, DampingOf::whole_span);
  const auto free_span = points_to_fit(summary["points"], a.road, DampingOf::free_span);
  const analysis::PowerLawFit fit = analysis::fit_power_law(whole);
  summary["fit"] = fit_json(fit);
  if (!free_span.empty()) summary["fit_free_span"] = fit_json(analysis::fit_power_law(free_span));
  for (const auto& [lowest, highest] : a.bands) {
    const double diameter = build::section_numbers(scene).diameter;
    json band = {{"lowest_over_diameter", lowest}, {"highest_over_diameter", highest}};
    band.update(
        fit_json(analysis::fit_power_law(free_span, {.lowest = lowest * diameter, .highest = highest * diameter})));
    summary["bands"].push_back(band);
  }
  summary["published"] = published_json(scene, fit, whole);
  return fit.law();
}

void add_onsets(const Scene& scene, const Quadrature& quadrature, const std::vector<Point>& points, json& summary) {
  const double mass = *casefile::mass_per_length(scene);
  json list = json::array();
  for (const Quadrature::Table& table : quadrature.tables()) {
    if (table.loss.onset() == 0) continue;
    std::vector<double> seen;
    for (const Point& point : points) {
      if (point.tension != table.tension || std::ranges::find(seen, point.frequency) != seen.end()) continue;
      seen.push_back(point.frequency);
      const double omega = 2 * std::numbers::pi * point.frequency;
      const double amplitude = table.loss.onset() * table.tension / (mass * omega * omega);
      json entry = {{"tension_N", table.tension},
                    {"frequency_Hz", point.frequency},
                    {"curvature_per_m", table.loss.onset()},
                    {"antinode_amplitude_m", amplitude}};
      if (scene.conductor) {
        entry["amplitude_over_diameter"] = amplitude / scene.conductor->strand.outer_diameter();
      }
      entry["slip_beyond"] = table.loss.loses();
      list.push_back(entry);
    }
  }
  if (!list.empty()) summary["no_slip_below"] = list;
}

}  // namespace strandyn::study
