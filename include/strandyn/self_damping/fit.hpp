#pragma once
/// \file What the points of a study say together: the power law fitted to them, beside the published ones; and the
/// amplitudes at which the first contact slips.

#include <string_view>

#include "strandyn/analysis/power_law.hpp"
#include "strandyn/analysis/published_laws.hpp"
#include "strandyn/self_damping/quadrature.hpp"

namespace strandyn::self_damping {

using Pair = std::array<double, 2>;

/// P = k A^l f^m/T^n, with its standard errors and 95 % intervals where the points determine them.
struct FitRow {
  std::optional<double> k{};
  std::optional<Pair> k_interval{};
  std::optional<double> l{}, l_error{}, m{}, m_error{}, n{}, n_error{};
  std::optional<Pair> l_interval{}, m_interval{}, n_interval{};
  std::optional<double> r2{};
  double scatter = 0;
  std::size_t points = 0, without_loss = 0;
  std::optional<double> no_slip_below{};
  bool leads = false;  ///< is it the one of several that a reader looks at first
};
template <class V>
void members(V& v, FitRow& f) {
  const auto shown = [&](const char* name) { return f.leads ? name : nullptr; };
  v.value("k", f.k, {.what = "the factor, for A in m, f in Hz, T in kN, P in W/m", .shown = shown("fit: factor k")});
  v.value("k_interval_95", f.k_interval, {.what = "its 95 % interval"});
  v.value("l", f.l, {.what = "the exponent of the amplitude", .shown = shown("fit: amplitude exponent l")});
  v.value("l_standard_error", f.l_error, {.what = "its standard error"});
  v.value("l_interval_95", f.l_interval, {.what = "its 95 % interval"});
  v.value("m", f.m, {.what = "the exponent of the frequency", .shown = shown("fit: frequency exponent m")});
  v.value("m_standard_error", f.m_error, {.what = "its standard error"});
  v.value("m_interval_95", f.m_interval, {.what = "its 95 % interval"});
  v.value("n", f.n, {.what = "the exponent of the tension", .shown = shown("fit: tension exponent n")});
  v.value("n_standard_error", f.n_error, {.what = "its standard error"});
  v.value("n_interval_95", f.n_interval, {.what = "its 95 % interval"});
  v.value("r2", f.r2, {.what = "R^2 of ln P", .shown = shown("fit: R2")});
  v.value("scatter", f.scatter, {.what = "rms residual of ln P"});
  v.value("points", f.points, {.what = "that were fitted"});
  v.value("points_without_loss", f.without_loss, {.what = "that lose nothing and were left out"});
  v.value("no_slip_below_m", f.no_slip_below, {.what = "the largest amplitude up to which no point loses anything"});
}

FitRow fit_row(const std::vector<analysis::SelfDampingPoint>& points);

/// What of a row is fitted [W/m]; nothing where it has none. What is lost in all has the air in it, as a laboratory
/// sees.
using PowerOf = std::optional<double> (*)(const PointRow&);
std::optional<double> friction_of(const PointRow& row);
std::optional<double> self_damping_of(const PointRow& row);
std::optional<double> dissipation_of(const PointRow& row);
/// The rows of the study's own method as points to fit; those of one grid where it is named.
std::vector<analysis::SelfDampingPoint> points_to_fit(const casefile::Scene& scene, const std::vector<PointRow>& rows,
                                                      PowerOf power, std::optional<std::string_view> grid = {});
bool same_powers(const std::vector<analysis::SelfDampingPoint>& a, const std::vector<analysis::SelfDampingPoint>& b);

/// A fit of the points in a band of amplitude over diameter.
struct BandRow {
  double lowest = 0, highest = 0;
  FitRow fit;
};
template <class V>
void members(V& v, BandRow& b) {
  v.value("lowest_over_diameter", b.lowest, {.what = "the lower end of the band"});
  v.value("highest_over_diameter", b.highest, {.what = "the upper end"});
  v.part(b.fit);
}

/// Points over a published law.
struct LevelRow {
  double least = 0, mean = 0, largest = 0;
};
template <class V>
void members(V& v, LevelRow& l) {
  v.value("least", l.least, {.what = "the least ratio"});
  v.value("mean", l.mean, {.what = "the geometric mean"});
  v.value("largest", l.largest, {.what = "the largest ratio"});
}
struct LawRow {
  std::string name;
  Pair l{}, m{};
  std::optional<Pair> n{};
  std::optional<double> k{};
  std::optional<double> k_over_similarity{};
  std::optional<LevelRow> points_over_law{};
};
template <class V>
void members(V& v, LawRow& r) {
  v.value("name", r.name, {.what = "whose law it is"});
  v.value("l", r.l, {.what = "exponent of the amplitude, from and to"});
  v.value("m", r.m, {.what = "exponent of the frequency"});
  v.value("n", r.n, {.what = "exponent of the tension"});
  v.value("k", r.k, {.what = "its factor for this conductor"});
  v.value("k_over_similarity", r.k_over_similarity,
          {.what = "the common factor over that of Noiseux's similarity: far from 1 it belongs to another conductor"});
  v.record("points_over_law", r.points_over_law, {.what = "the points of the study over it"});
}
struct OutsideRow {
  std::optional<double> l{}, m{}, n{};
};
template <class V>
void members(V& v, OutsideRow& o) {
  v.value("l", o.l, {.what = "of the exponent of the amplitude; 0 inside the band"});
  v.value("m", o.m, {.what = "of that of the frequency"});
  v.value("n", o.n, {.what = "of that of the tension"});
}
struct PublishedRow {
  std::string source;
  Pair l{}, m{}, n{};
  OutsideRow fit_outside_by;
  std::vector<LawRow> laws;
};
template <class V>
void members(V& v, PublishedRow& p) {
  v.value("source", p.source, {.what = "where the laws are gathered"});
  v.value("l", p.l, {.what = "the band of all published exponents of the amplitude"});
  v.value("m", p.m, {.what = "of the frequency"});
  v.value("n", p.n, {.what = "of the tension"});
  v.record("fit_outside_by", p.fit_outside_by, {.what = "how far the fit lies outside"});
  v.list("laws", p.laws, {.what = "each law"});
}

/// Fits of the study's own method.
struct Fits {
  FitRow fit;
  std::optional<FitRow> friction{};  ///< where something else damps, too
  std::optional<FitRow> free_span{};
  std::optional<std::vector<BandRow>> bands{};
  PublishedRow published;
  std::optional<analysis::PowerLaw> law{};  ///< of the self-damping, without the air
  std::optional<std::string> warning{};     ///< of a common factor that belongs to other conductors
};
template <class V>
void members(V& v, Fits& f) {
  v.record("fit", f.fit,
           {.what = "the power law of all that the points of the study's method lose: what a laboratory sees, still "
                    "air included where there is air"});
  v.record("fit_friction", f.friction, {.what = "the same of friction alone, where something else damps, too"});
  v.record("fit_free_span", f.free_span, {.what = "the same without the end loops"});
  v.list("bands", f.bands, {.what = "fits of bands of amplitude, of the free span"});
  v.record("published", f.published, {.what = "the published laws beside it"});
}
/// Of a scene with a conductor whose strength is known.
analysis::RatedConductor rated_conductor(const casefile::Scene& scene);

Fits fit_points(const casefile::Scene& scene, const std::vector<PointRow>& rows);
/// Where d/sqrt(m RTS) is more than three times off Noiseux's similarity for this conductor.
std::optional<std::string> warning_of_common_factor(const casefile::Scene& scene);

/// Nothing slips below this antinode amplitude.
struct OnsetRow {
  double tension = 0, frequency = 0, curvature = 0, antinode_amplitude = 0;
  std::optional<double> amplitude_over_diameter{};
  bool slip_beyond = false;
};
template <class V>
void members(V& v, OnsetRow& o) {
  v.value("tension_N", o.tension, {.what = "the tension"});
  v.value("frequency_Hz", o.frequency, {.what = "the frequency"});
  v.value("curvature_per_m", o.curvature, {.what = "at which the first contact slips"});
  v.value("antinode_amplitude_m", o.antinode_amplitude, {.what = "of the free span that has this curvature"});
  v.value("amplitude_over_diameter", o.amplitude_over_diameter, {.what = "the same over the diameter"});
  v.value("slip_beyond", o.slip_beyond, {.what = "whether anything slips in the range of the study"});
}
std::vector<OnsetRow> onsets_of(const casefile::Scene& scene, const Quadrature& quadrature,
                                const std::vector<Point>& points);

}  // namespace strandyn::self_damping
