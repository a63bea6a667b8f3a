#include "strandyn/self_damping/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/analysis/published_laws.hpp"

namespace strandyn::self_damping {

using casefile::Scene;

namespace {

Pair pair(const analysis::Interval& interval) {
  return {interval.low, interval.high};
}

void set(const std::optional<analysis::Estimate>& estimate, std::optional<double>& value, std::optional<double>& error,
         std::optional<Pair>& interval) {
  if (!estimate) return;
  value = estimate->value;
  error = estimate->standard_error;
  if (estimate->interval_95) interval = pair(*estimate->interval_95);
}

FitRow row_of(const analysis::PowerLawFit& fit) {
  FitRow row{.r2 = fit.r_squared,
             .scatter = fit.scatter,
             .points = fit.points,
             .without_loss = fit.without_loss,
             .no_slip_below = fit.no_slip_below};
  if (const auto law = fit.law()) {
    row.k = law->factor;
    if (const auto& log_k = fit.log_factor->interval_95) {
      const Pair interval{std::exp(log_k->low), std::exp(log_k->high)};
      if (std::isfinite(interval[1])) row.k_interval = interval;
    }
  }
  set(fit.amplitude, row.l, row.l_error, row.l_interval);
  set(fit.frequency, row.m, row.m_error, row.m_interval);
  set(fit.tension, row.n, row.n_error, row.n_interval);
  return row;
}

std::optional<double> free_span_dissipation_of(const PointRow& row) {
  if (!row.free_span) return std::nullopt;
  return *row.free_span + (row.parts ? row.parts->air_free_span.value_or(0) : 0);
}

std::optional<LevelRow> level_of(const analysis::PowerLaw& law, const std::vector<analysis::SelfDampingPoint>& points) {
  LevelRow level;
  double sum = 0;
  std::size_t count = 0;
  for (const analysis::SelfDampingPoint& point : points) {
    if (point.power <= 0) continue;
    const double ratio = point.power / analysis::power(law, point.at);
    level.least = count == 0 ? ratio : std::min(level.least, ratio);
    level.largest = std::max(level.largest, ratio);
    sum += std::log(ratio);
    ++count;
  }
  if (count == 0) return std::nullopt;
  level.mean = std::exp(sum / static_cast<double>(count));
  return level;
}

/// The published exponents, how far the fit lies outside of their band, and the levels where a factor is known.
PublishedRow published(const Scene& scene, const analysis::PowerLawFit& fit,
                       const std::vector<analysis::SelfDampingPoint>& points) {
  const analysis::ExponentBands bands = analysis::published_bands();
  const analysis::BandComparison comparison = analysis::compare_with_published(fit);
  PublishedRow out{.source = std::string(analysis::published_laws_source),
                   .l = pair(bands.amplitude),
                   .m = pair(bands.frequency),
                   .n = pair(bands.tension),
                   .fit_outside_by = {.l = comparison.amplitude, .m = comparison.frequency, .n = comparison.tension},
                   .laws = {}};
  for (const analysis::PublishedLaw& law : analysis::published_laws()) {
    LawRow& row = out.laws.emplace_back();
    row.name = law.name;
    row.l = pair(law.amplitude);
    row.m = pair(law.frequency);
    if (law.tension) row.n = pair(*law.tension);
    if (!scene.conductor || scene.conductor->strand.rated_strength <= 0) continue;
    const analysis::RatedConductor rated = rated_conductor(scene);
    const auto full = analysis::law_for(law, rated);
    if (!full) continue;
    row.k = full->factor;
    if (law.takes_common_factor) row.k_over_similarity = full->factor / analysis::similarity_factor(rated);
    row.points_over_law = level_of(*full, points);
  }
  return out;
}

}  // namespace

analysis::RatedConductor rated_conductor(const Scene& scene) {
  return {.diameter = scene.conductor->strand.outer_diameter(),
          .mass_per_length = *casefile::mass_per_length(scene),
          .rated_strength = scene.conductor->strand.rated_strength};
}

std::optional<std::string> warning_of_common_factor(const Scene& scene) {
  if (!scene.conductor || scene.conductor->strand.rated_strength <= 0) return std::nullopt;
  constexpr double belongs = 3;  // times more or less
  const analysis::RatedConductor rated = rated_conductor(scene);
  const double ratio = analysis::common_factor(rated) / analysis::similarity_factor(rated);
  if (ratio < belongs && ratio > 1 / belongs) return std::nullopt;
  return fmt::format(
      "the factor d/sqrt(m RTS) of published laws belongs to conductors of about 30 mm: for this one it is {:.3g} "
      "times that of Noiseux's own similarity; take \"Noiseux, by similarity\" beside it",
      ratio);
}

std::optional<double> friction_of(const PointRow& row) {
  return row.parts ? row.parts->friction : row.self_damping;
}
std::optional<double> self_damping_of(const PointRow& row) {
  return row.self_damping;
}
std::optional<double> dissipation_of(const PointRow& row) {
  if (!row.self_damping) return std::nullopt;
  return *row.self_damping + (row.parts ? row.parts->air : 0);
}

std::vector<analysis::SelfDampingPoint> points_to_fit(const Scene& scene, const std::vector<PointRow>& rows,
                                                      PowerOf power, std::optional<std::string_view> grid) {
  const std::string_view method = name_of(scene.as<casefile::SelfDampingAnalysis>().method);
  std::vector<analysis::SelfDampingPoint> points;
  for (const PointRow& row : rows) {
    const std::optional<double> value = power(row);
    if (row.method != method || !value || (grid && row.grid != *grid)) continue;
    points.push_back(
        {.at = {.antinode_amplitude = row.antinode_amplitude, .frequency = row.frequency, .tension = row.tension},
         .power = *value});
  }
  return points;
}

bool same_powers(const std::vector<analysis::SelfDampingPoint>& a, const std::vector<analysis::SelfDampingPoint>& b) {
  return std::ranges::equal(a, b, {}, &analysis::SelfDampingPoint::power, &analysis::SelfDampingPoint::power);
}

FitRow fit_row(const std::vector<analysis::SelfDampingPoint>& points) {
  return row_of(analysis::fit_power_law(points));
}

Fits fit_points(const Scene& scene, const std::vector<PointRow>& rows) {
  const auto& keys = scene.as<casefile::SelfDampingAnalysis>();
  const auto whole = points_to_fit(scene, rows, dissipation_of);
  const auto free_span = points_to_fit(scene, rows, free_span_dissipation_of);
  const auto damping = points_to_fit(scene, rows, self_damping_of);
  const auto friction = points_to_fit(scene, rows, friction_of);
  const analysis::PowerLawFit fit = analysis::fit_power_law(whole);
  Fits fits{.fit = row_of(fit), .published = published(scene, fit, whole)};
  fits.fit.leads = true;
  fits.law = same_powers(damping, whole) ? fit.law() : analysis::fit_power_law(damping).law();
  if (!same_powers(friction, whole)) fits.friction = fit_row(friction);
  fits.warning = warning_of_common_factor(scene);
  if (!free_span.empty()) fits.free_span = fit_row(free_span);
  for (const auto& [lowest, highest] : keys.bands) {
    const double diameter = scene.conductor->strand.outer_diameter();
    const analysis::AmplitudeBand band{.lowest = lowest * diameter, .highest = highest * diameter};
    if (!fits.bands) fits.bands.emplace();
    fits.bands->push_back(
        {.lowest = lowest, .highest = highest, .fit = row_of(analysis::fit_power_law(free_span, band))});
  }
  return fits;
}

std::vector<OnsetRow> onsets_of(const Scene& scene, const Quadrature& quadrature, const std::vector<Point>& points) {
  std::vector<OnsetRow> rows;
  for (const Quadrature::Table& table : quadrature.tables()) {
    if (table.loss.onset() == 0) continue;
    std::vector<double> seen;
    for (const Point& point : points) {
      if (point.tension != table.tension || std::ranges::find(seen, point.frequency) != seen.end()) continue;
      seen.push_back(point.frequency);
      OnsetRow row{.tension = table.tension,
                   .frequency = point.frequency,
                   .curvature = table.loss.onset(),
                   .antinode_amplitude = table.loss.onset() / quadrature.curvature_of_small_amplitude(point),
                   .slip_beyond = table.loss.loses()};
      if (scene.conductor) {
        row.amplitude_over_diameter = row.antinode_amplitude / scene.conductor->strand.outer_diameter();
      }
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace strandyn::self_damping
