#pragma once
/// \file `type = "self-damping"`: power per length over frequency, amplitude and tension.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/damper.hpp"
#include "strandyn/casefile/declare.hpp"
#include "strandyn/casefile/periodic.hpp"
#include "strandyn/casefile/wind.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class DampingMethod { quadrature, periodic, transient, foti_2018 };
constexpr auto words_of(DampingMethod) {
  return std::array{Named{DampingMethod::quadrature, "quadrature"}, Named{DampingMethod::periodic, "periodic"},
                    Named{DampingMethod::transient, "transient"}, Named{DampingMethod::foti_2018, "foti-2018"}};
}

enum class ModeShape { sine, string, clamped };
constexpr auto words_of(ModeShape) {
  return std::array{Named{ModeShape::sine, "sine"}, Named{ModeShape::string, "string"},
                    Named{ModeShape::clamped, "clamped"}};
}

enum class BenchStart { mode, rest };
constexpr auto words_of(BenchStart) {
  return std::array{Named{BenchStart::mode, "mode"}, Named{BenchStart::rest, "rest"}};
}

enum class BalancedBy { quadrature, foti_2018, fit, published };
constexpr auto words_of(BalancedBy) {
  return std::array{Named{BalancedBy::quadrature, "quadrature"}, Named{BalancedBy::foti_2018, "foti-2018"},
                    Named{BalancedBy::fit, "fit"}, Named{BalancedBy::published, "published"}};
}

/// [[analysis.at]]: one point of a self-damping study, beside its grid.
struct DampingAt {
  std::optional<double> frequency;                ///< [Hz] this or
  std::optional<int> mode;                        ///< that of this mode, counted from 1
  std::optional<double> amplitude_over_diameter;  ///< [-] one of these three
  std::optional<double> antinode_amplitude;       ///< [m]
  std::optional<double> antinode_velocity;        ///< [m/s]
  std::optional<double> tension_rts;              ///< [-] this or
  std::optional<double> tension;                  ///< [N]
  std::optional<DampingMethod> method;            ///< the study's unless given
};

template <class V>
void keys(V& v, DampingAt& a) {
  v.one_of({"frequency_Hz", "mode"}, {.required = true});
  v.number("frequency_Hz", a.frequency, {.help = "the frequency", .unit = units::Hz, .above = 0});
  v.number("mode", a.mode, {.help = "the mode of the span, whose frequency is taken", .at_least = 1});
  v.one_of({"amplitude_over_diameter", "antinode_amplitude_mm", "antinode_velocity_m_per_s"}, {.required = true});
  v.number("amplitude_over_diameter", a.amplitude_over_diameter,
           {.help = "the amplitude of the antinode as a part of the conductor's diameter", .above = 0});
  v.number("antinode_amplitude_mm", a.antinode_amplitude,
           {.help = "the amplitude of the antinode", .unit = units::mm, .above = 0});
  v.number("antinode_velocity_m_per_s", a.antinode_velocity,
           {.help = "the velocity amplitude of the antinode", .unit = units::m_per_s, .above = 0});
  v.one_of({"tension_rts", "tension_kN"}, {.required = true});
  v.number("tension_rts", a.tension_rts,
           {.help = "the tension as a part of the rated strength", .above = 0, .at_most = 1});
  v.number("tension_kN", a.tension, {.help = "the tension", .unit = units::kN, .above = 0});
  v.choice("method", a.method, {.help = "how the point is computed (as the others unless given)", .old_name = "road"});
}

/// [analysis.foti_2018]: the numbers of the simplified loss; the strand's own where they are not given.
struct SimplifiedLoss {
  std::optional<double> EI;                       ///< [N m^2]
  std::optional<double> chi_0_at_rated_strength;  ///< [1/m] in proportion to the tension
};

template <class V>
void keys(V& v, SimplifiedLoss& s) {
  v.number("EI_N_m2", s.EI,
           {.help = "the bending stiffness that friction gives (EI_max less EI_min of the strand unless given)",
            .unit = units::N_m2,
            .above = 0});
  v.number("chi_0_at_rated_strength_per_m", s.chi_0_at_rated_strength,
           {.help = "the yield curvature under the rated strength, in proportion to the tension "
                    "(that of the strand at each tension unless given)",
            .unit = units::per_m,
            .above = 0});
}

/// [analysis.quadrature]: the table of the sectional loss that the quadrature reads.
struct QuadratureKeys {
  int steps = 64;             ///< of half a cycle
  int knots_per_decade = 24;  ///< to begin with, of the amplitude beyond first slip
  double tolerance = 1e-3;    ///< [-] of the loss in the middle between two knots
};

template <class V>
void keys(V& v, QuadratureKeys& q) {
  v.number("steps", q.steps,
           {.help = "the number of steps in which a section is bent from one side to the other",
            .at_least = 4,
            .at_most = 4096,
            .multiple_of = 2});
  v.number("knots_per_decade", q.knots_per_decade,
           {.help = "the number of amplitudes in a decade beyond first slip at which the loss is tabulated at least",
            .at_least = 2,
            .at_most = 200});
  v.number(
      "tolerance", q.tolerance,
      {.help = "the error of the loss between two amplitudes, as a part of it, above which one is put between them",
       .at_least = 1e-6,
       .at_most = 1});
}

/// Places of a damper that are tried one after the other.
struct PlaceScan {
  double from = 0, to = 0;  ///< [m] from the support
  int count = 20;
};

template <class V>
void keys(V& v, PlaceScan& s) {
  v.number("from", s.from, {.help = "the smallest distance from the support in metres", .above = 0, .required = true});
  v.number("to", s.to, {.help = "the largest", .above = 0, .required = true});
  v.number("count", s.count, {.help = "how many places", .at_least = 2, .at_most = 1000});
}

/// [[analysis.energy_balance]]
struct EnergyBalanceKeys {
  WindCurve wind = WindCurve::cigre;
  double turbulence_intensity = 0;  ///< [-]
  double strouhal = 0.2;            ///< [-]
  std::vector<double> frequencies;  ///< [Hz] empty: those of the study
  BalancedBy self_damping = BalancedBy::quadrature;
  std::string law;               ///< `published`: its name
  std::optional<double> factor;  ///< `published`: k for m, Hz, kN
  std::optional<double> span;    ///< [m] between the clamps, with dampers
  std::vector<DamperKeys> dampers;
  std::optional<PlaceScan> damper_at;             ///< of the first damper
  std::vector<std::array<double, 2>> wind_hours;  ///< [m/s], [h] a year
};

template <class V>
void keys(V& v, EnergyBalanceKeys& b) {
  v.choice("wind", b.wind, {.help = "the curve of wind power"});
  v.number("turbulence_intensity", b.turbulence_intensity,
           {.help = "the turbulence intensity of the wind, deviation over mean", .at_least = 0, .below = 1});
  v.number("strouhal", b.strouhal,
           {.help = "the Strouhal number, which ties the wind speed to the frequency", .above = 0});
  v.numbers(
      "frequencies_Hz", b.frequencies,
      {.help = "the frequencies, one or a list (those of the study unless given)", .unit = units::Hz, .above = 0});
  v.choice("self_damping", b.self_damping, {.help = "what damps"});
  v.when("self_damping", b.self_damping, {BalancedBy::published}, [&] {
    v.text("law", b.law, {.help = "the name of the published law", .required = true});
    v.number("factor", b.factor,
             {.help = "its factor k, for metres, hertz and kilonewtons (d/sqrt(m RTS) unless given)", .above = 0});
  });
  v.number("span_m", b.span, {.help = "the length of the span that dampers protect", .unit = units::m, .above = 0});
  v.tables("damper", b.dampers, {.help = "Stockbridge dampers on that span"});
  v.table("damper_at_m", b.damper_at, {.help = "places at which the first damper is tried, one after the other"});
  v.rows("wind_hours", b.wind_hours,
         {{{.help = "speed", .unit = units::m_per_s, .above = 0}, {.help = "hours a year", .at_least = 0}}},
         {.help = "how long the wind blows across the line at these speeds in a year, for the damage of that year"});
}

/// [analysis.bench]: the test bench of the method "transient".
struct BenchKeys {
  BenchStart start = BenchStart::mode;
  int cycles = 20;                    ///< measured, once the vibration is steady
  int decay_cycles = 12;              ///< after the shaker is let go
  int max_cycles = 3000;              ///< until the vibration is steady
  double amplitude_tolerance = 2e-3;  ///< [-] of the wanted antinode amplitude
};

template <class V>
void keys(V& v, BenchKeys& b) {
  v.choice("start", b.start,
           {.help = "whether the span starts in its mode at the wanted amplitude, or at rest as in a laboratory"});
  v.number("cycles", b.cycles, {.help = "the number of cycles that are measured in steady state", .at_least = 4});
  v.number("decay_cycles", b.decay_cycles, {.help = "the number of cycles after the shaker is let go", .at_least = 6});
  v.number("max_cycles", b.max_cycles,
           {.help = "the number of cycles after which a vibration that is not steady is given up", .at_least = 40});
  v.number("amplitude_tolerance", b.amplitude_tolerance,
           {.help = "how near the antinode amplitude must come to the wanted one, as a part of it",
            .at_least = 1e-5,
            .at_most = 0.1});
}

struct SelfDampingAnalysis {
  static constexpr std::string_view word = "self-damping";
  static constexpr bool sets_tension = true;              ///< the span needs none of its own
  std::vector<double> frequencies;                        ///< [Hz] this or
  std::vector<double> modes;                              ///< counted from 1
  std::vector<double> amplitudes_over_diameter;           ///< [-] this or
  std::vector<double> antinode_amplitudes;                ///< [m]
  std::vector<double> antinode_velocities;                ///< [m/s] beside the others, or in their place
  std::optional<double> highest_amplitude_over_diameter;  ///< [-] of the points that the velocities give
  std::vector<double> tensions_rts;                       ///< [-] this or
  std::vector<double> tensions;                           ///< [N]
  DampingMethod method = DampingMethod::quadrature;
  ModeShape mode_shape = ModeShape::sine;
  std::vector<DampingAt> at;
  std::vector<std::array<double, 2>> bands;  ///< [-] of amplitude over diameter
  PeriodicKeys periodic;
  QuadratureKeys quadrature;
  SimplifiedLoss simplified;
  BenchKeys bench;
  std::vector<EnergyBalanceKeys> energy_balances;

  bool has_grid() const { return !frequencies.empty() || !modes.empty(); }
  bool names_modes() const;  ///< of the grid or of a single point
  bool takes(DampingMethod method) const;
};

template <class V>
void keys(V& v, SelfDampingAnalysis& a) {
  v.one_of({"frequencies_Hz", "modes"}, {});
  v.numbers("frequencies_Hz", a.frequencies, {.help = "the frequencies, one or a list", .unit = units::Hz, .above = 0});
  v.numbers("modes", a.modes,
            {.help = "modes of the span, whose frequencies are taken at each tension, one or a list",
             .at_least = 1,
             .whole = true});
  v.one_of({"amplitude_over_diameter", "antinode_amplitude_mm"}, {});
  v.numbers("amplitude_over_diameter", a.amplitudes_over_diameter,
            {.help = "antinode amplitudes as parts of the conductor's diameter, one or a list", .above = 0});
  v.numbers("antinode_amplitude_mm", a.antinode_amplitudes,
            {.help = "antinode amplitudes, one or a list", .unit = units::mm, .above = 0});
  v.numbers(
      "antinode_velocity_m_per_s", a.antinode_velocities,
      {.help = "velocity amplitudes of the antinode, one or a list, beside the amplitudes or in their place (0.05 to "
               "0.4 unless any is given: what laboratories run)",
       .unit = units::m_per_s,
       .above = 0});
  v.number(
      "highest_amplitude_over_diameter", a.highest_amplitude_over_diameter,
      {.help = "the antinode amplitude over the diameter above which the velocities of the grid give no point (0.5 "
               "where they are not given)",
       .above = 0});
  v.one_of({"tensions_rts", "tensions_kN"}, {});
  v.numbers("tensions_rts", a.tensions_rts,
            {.help = "tensions as parts of the rated strength, one or a list", .above = 0, .at_most = 1});
  v.numbers("tensions_kN", a.tensions, {.help = "tensions, one or a list", .unit = units::kN, .above = 0});
  v.choice("method", a.method, {.help = "how a point is computed", .old_name = "road"});
  v.choice(
      "mode_shape", a.mode_shape,
      {.help = "the shape that the quadrature goes over: the sine of a wave that feels the bending stiffness of the "
               "law, that of a taut string without any, or the mode of the span with its clamped ends"});
  v.tables("at", a.at, {.help = "single points beside the grid, each with a method of its own if wanted"});
  v.rows("bands_over_diameter", a.bands,
         {{{.help = "the smallest antinode amplitude over the diameter", .at_least = 0},
           {.help = "the largest one", .above = 0}}},
         {.help = "bands of amplitude over diameter that are fitted one by one, rows of smallest and largest"});
  v.table("periodic", a.periodic, {.help = "how a periodic response is solved"});
  v.table("quadrature", a.quadrature, {.help = "the table of the sectional loss that \"quadrature\" reads"});
  v.table("foti_2018", a.simplified, {.help = "the numbers of the closed form \"foti-2018\""});
  v.table("bench", a.bench, {.help = "the test bench of the method \"transient\""});
  v.tables("energy_balance", a.energy_balances, {.help = "wind against self-damping of the bare conductor"});
}

}  // namespace strandyn::casefile
