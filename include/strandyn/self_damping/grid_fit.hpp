#pragma once
/// \file The power laws of one grid of points: of friction alone, of self-damping, of all that is lost; and what a fit
/// of a whole grid hides, the exponents from point to point.
///
/// Local exponents of ln P by central differences over neighbours on the grid (one-sided at its ends):
///     l = d ln P/d ln A,   m = d ln P/d ln f,   n = -d ln P/d ln T
/// Along f, a grid of antinode velocities changes A as well: its share l dlnA is taken out.

#include "strandyn/self_damping/fit.hpp"

namespace strandyn::self_damping {

/// Smallest, median, largest.
using Triple = std::array<double, 3>;

struct LocalExponents {
  analysis::TestCondition at;
  std::optional<double> l{}, m{}, n{};
};

struct LocalRow {
  std::optional<Triple> l{}, m{}, n{};
};
template <class V>
void members(V& v, LocalRow& r) {
  v.value("l", r.l, {.what = "exponents of the amplitude: the smallest, the median, the largest"});
  v.value("m", r.m, {.what = "of the frequency"});
  v.value("n", r.n, {.what = "of the tension"});
}

/// Fits of the points of one grid.
struct GridFit {
  FitRow self_damping;
  std::optional<FitRow> friction{};     ///< where something else damps too
  std::optional<FitRow> dissipation{};  ///< with the air, where there is air
  LocalRow local;                       ///< of `dissipation`, else of `self_damping`
  std::optional<std::string> caveat{};
};
template <class V>
void members(V& v, GridFit& g) {
  v.record("self_damping", g.self_damping, {.what = "the power law of the self-damping"});
  v.record("friction", g.friction, {.what = "that of friction alone"});
  v.record("dissipation", g.dissipation, {.what = "that of all that is lost, still air included"});
  v.record("local_exponents", g.local, {.what = "from point to point of the grid, of all that is lost"});
  v.value("caveat", g.caveat, {.what = "where the points are no power law"});
}

/// The grids of a study by the study's own method.
struct GridFits {
  std::optional<GridFit> by_velocity{}, by_amplitude{};
};
template <class V>
void members(V& v, GridFits& g) {
  v.record("fit_by_velocity", g.by_velocity, {.what = "fits of the points that antinode velocities gave"});
  v.record("fit_by_amplitude", g.by_amplitude, {.what = "fits of the points that amplitudes gave"});
}
GridFits fit_grids(const casefile::Scene& scene, const std::vector<PointRow>& rows);

/// At every point that has a loss; absent where it has no neighbour along a variable.
std::vector<LocalExponents> local_exponents(const std::vector<analysis::SelfDampingPoint>& points);
/// What is beyond what laboratories run, or the formulas hold for: antinode velocity, amplitude, attached flow,
/// wavelength.
std::vector<std::string> warnings_of_points(const casefile::Scene& scene, const std::vector<PointRow>& rows);

}  // namespace strandyn::self_damping
