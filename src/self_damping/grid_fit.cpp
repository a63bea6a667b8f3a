#include "strandyn/self_damping/grid_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <tuple>

#include "strandyn/air/still_air.hpp"

namespace strandyn::self_damping {

using analysis::SelfDampingPoint;
using analysis::TestCondition;
using casefile::Scene;

namespace {

/// What a power law may be off by before it is called none, and how far its exponents may wander.
constexpr double largest_scatter = 0.1;
constexpr double largest_range = 0.5;
/// What laboratories run: beyond, the loss is an extrapolation of the section law.
constexpr double highest_velocity = 1;   // [m/s]
constexpr double highest_amplitude = 1;  // [-] over the diameter
constexpr double shortest_wave = 40;     // [-] over the diameter: a loop of 20

bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::abs(b);
}

/// Of every point the place of its value among all values, from the smallest; values that are alike share a place.
template <class Of>
std::vector<std::size_t> places(const std::vector<SelfDampingPoint>& points, const Of& of) {
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return of(points[i].at); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const bool same = alike(of(points[order[k - 1]].at), of(points[order[k]].at));
    place[order[k]] = place[order[k - 1]] + (same ? 0 : 1);
  }
  return place;
}

/// Neighbours of every point along a variable, where two others stay: the next smaller and the next larger one, or
/// itself. In n log n: grids have tens of thousands of points.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(const std::vector<std::size_t>& stays,
                                                            const std::vector<std::size_t>& stays_too,
                                                            const std::vector<std::size_t>& along) {
  std::vector<std::size_t> order(along.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto line = [&](std::size_t i) { return std::pair(stays[i], stays_too[i]); };
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(stays[i], stays_too[i], along[i], i); });
  std::vector<std::pair<std::size_t, std::size_t>> beside(along.size());
  const auto look = [&](auto begin, auto end, auto side) {
    std::optional<std::size_t> before{}, last{};  // of the line: the last point of another place, the last point
    for (auto at = begin; at != end; ++at) {
      if (last && line(*last) != line(*at)) before = last = std::nullopt;
      if (last && along[*last] != along[*at]) before = last;
      beside[*at].*side = before.value_or(*at);
      last = *at;
    }
  };
  look(order.begin(), order.end(), &std::pair<std::size_t, std::size_t>::first);
  look(order.rbegin(), order.rend(), &std::pair<std::size_t, std::size_t>::second);
  return beside;
}

double velocity_of(const TestCondition& at) {
  return at.frequency * at.antinode_amplitude;
}

std::optional<Triple> spread(const std::vector<LocalExponents>& all, std::optional<double> LocalExponents::*which) {
  std::vector<double> values;
  for (const LocalExponents& local : all) {
    if (local.*which) values.push_back(*(local.*which));
  }
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  return Triple{values.front(), values[values.size() / 2], values.back()};
}

std::optional<std::string> caveat_of(const FitRow& fit, const LocalRow& local) {
  std::string words;
  const auto wanders = [&](const std::optional<Triple>& range, const char* name) {
    if (!range || range->back() - range->front() <= largest_range) return;
    words += fmt::format("{}{} from {:.2f} to {:.2f}", words.empty() ? "" : ", ", name, range->front(), range->back());
  };
  wanders(local.l, "l");
  wanders(local.m, "m");
  wanders(local.n, "n");
  if (words.empty() && fit.scatter <= largest_scatter) return std::nullopt;
  return fmt::format("no power law: the points lie {:.0f} % off the fitted one (rms){}{}", 100 * fit.scatter,
                     words.empty() ? "" : ", and from point to point of the grid the exponents go: ", words);
}

std::optional<GridFit> fit_of(const Scene& scene, const std::vector<PointRow>& rows, std::string_view grid) {
  const auto damping = points_to_fit(scene, rows, self_damping_of, grid);
  if (damping.empty()) return std::nullopt;
  GridFit fit{.self_damping = fit_row(damping), .local = {}};
  const auto friction = points_to_fit(scene, rows, friction_of, grid);
  const auto lost = points_to_fit(scene, rows, dissipation_of, grid);
  if (!same_powers(friction, damping)) fit.friction = fit_row(friction);
  if (!same_powers(lost, damping)) fit.dissipation = fit_row(lost);
  const std::vector<LocalExponents> local = local_exponents(lost);
  fit.local = {.l = spread(local, &LocalExponents::l),
               .m = spread(local, &LocalExponents::m),
               .n = spread(local, &LocalExponents::n)};
  fit.caveat = caveat_of(fit.dissipation.value_or(fit.self_damping), fit.local);
  return fit;
}

}  // namespace

std::vector<LocalExponents> local_exponents(const std::vector<SelfDampingPoint>& all_points) {
  std::vector<SelfDampingPoint> points;  // where nothing is lost no power law has an exponent
  std::ranges::copy_if(all_points, std::back_inserter(points), [](const auto& point) { return point.power > 0; });
  const auto amplitude = [](const TestCondition& at) { return at.antinode_amplitude; };
  const auto frequency = [](const TestCondition& at) { return at.frequency; };
  const auto tension = [](const TestCondition& at) { return at.tension; };
  const auto rise = [&](const std::pair<std::size_t, std::size_t>& between, const auto& of) {
    return std::log(of(points[between.second].at) / of(points[between.first].at));
  };
  const auto of_power = [&](const std::pair<std::size_t, std::size_t>& between) {
    // Not of the ratio: just above first slip a loss may be so small that the ratio overflows.
    return std::log(points[between.second].power) - std::log(points[between.first].power);
  };
  const auto A = places(points, amplitude), f = places(points, frequency), T = places(points, tension);
  const auto along_A = neighbours(f, T, A), along_T = neighbours(f, A, T);
  const auto at_same_amplitude = neighbours(T, A, f), at_same_velocity = neighbours(T, places(points, velocity_of), f);
  std::vector<LocalExponents> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto there = [](const auto& between) { return between.first != between.second; };
    LocalExponents local{.at = points[i].at};
    if (there(along_A[i])) local.l = of_power(along_A[i]) / rise(along_A[i], amplitude);
    const auto& along_f = there(at_same_amplitude[i]) ? at_same_amplitude[i] : at_same_velocity[i];
    if (there(along_f) && local.l) {
      local.m = (of_power(along_f) - *local.l * rise(along_f, amplitude)) / rise(along_f, frequency);
    }
    if (there(along_T[i])) local.n = -of_power(along_T[i]) / rise(along_T[i], tension);
    all.push_back(local);
  }
  return all;
}

GridFits fit_grids(const Scene& scene, const std::vector<PointRow>& rows) {
  return {.by_velocity = fit_of(scene, rows, velocity_grid), .by_amplitude = fit_of(scene, rows, amplitude_grid)};
}

std::vector<std::string> warnings_of_points(const Scene& scene, const std::vector<PointRow>& rows) {
  const double mass = *casefile::mass_per_length(scene);
  const double diameter = scene.conductor ? scene.conductor->strand.outer_diameter() : 0;
  std::size_t fast = 0, wide = 0, torn = 0, brief = 0;
  double fastest = 0, widest = 0, most_torn = 0, briefest = INFINITY;
  for (const PointRow& row : rows) {
    const double velocity = 2 * std::numbers::pi * row.frequency * row.antinode_amplitude;
    fast += velocity > highest_velocity ? 1 : 0;
    fastest = std::max(fastest, velocity);
    if (diameter == 0) continue;
    const double amplitude = row.antinode_amplitude / diameter;
    const double wave = std::sqrt(row.tension / mass) / row.frequency / diameter;
    wide += amplitude > highest_amplitude ? 1 : 0;
    brief += wave < shortest_wave ? 1 : 0;
    widest = std::max(widest, amplitude);
    briefest = std::min(briefest, wave);
    if (!scene.air || scene.air->still.drag_per_K > 0 || scene.air->still.drag_coefficient > 0) continue;
    const double through_air = scene.air->diameter.value_or(diameter);
    const double K = 2 * std::numbers::pi * row.antinode_amplitude / through_air;
    const double over = K / air::honji_limit(scene.air->still, through_air, row.frequency);
    torn += over > 1 ? 1 : 0;
    most_torn = std::max(most_torn, over);
  }
  std::vector<std::string> warnings;
  const auto warn = [&](std::size_t count, const std::string& what) {
    if (count > 0) warnings.push_back(fmt::format("{} of {} points {}", count, rows.size(), what));
  };
  warn(fast,
       fmt::format("have an antinode velocity above {:g} m/s, up to {:.3g}: laboratories run 0.05 to 0.4 m/s, and "
                   "no measurement stands beside these points",
                   highest_velocity, fastest));
  warn(wide, fmt::format("have an antinode amplitude above the diameter, up to {:.3g} of it: no laboratory runs them",
                         widest));
  warn(torn, fmt::format("swing so wide that the flow of the air is attached no more, up to {:.3g} times the limit of "
                         "A/D, and the air takes more than is said: air.drag_per_K stands for that",
                         most_torn));
  warn(brief,
       fmt::format("have a wave shorter than {:g} diameters, down to {:.3g}: plane sections of a strand are doubtful "
                   "there",
                   shortest_wave, briefest));
  return warnings;
}

}  // namespace strandyn::self_damping
