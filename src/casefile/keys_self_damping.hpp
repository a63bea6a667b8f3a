#pragma once
/// \file The keys of `[analysis] type = "self-damping"`. What a declaration may say: keys.hpp.

#include "declare.hpp"
#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

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
  v.choice("road", a.method, {.help = "how the point is computed (as the others unless given)"});
}

template <class V>
void keys(V& v, PeriodicKeys& p) {
  v.number("harmonics", p.harmonics, {.help = "the number of harmonics of the motion", .at_least = 1, .at_most = 31});
  v.number("samples", p.samples,
           {.help = "the number of samples of a cycle in which friction is followed, at least 4 harmonics + 4",
            .at_least = 8,
            .multiple_of = 2});
}

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
}

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

template <class V>
void keys(V& v, SelfDampingAnalysis& a) {
  v.one_of({"frequencies_Hz", "modes"}, {});
  v.numbers("frequencies_Hz", a.frequencies, {.help = "the frequencies, one or a list", .unit = units::Hz, .above = 0});
  v.numbers("modes", a.modes,
            {.help = "modes of the span, whose frequencies are taken at each tension, one or a list",
             .at_least = 1,
             .whole = true});
  v.one_of({"amplitude_over_diameter", "antinode_amplitude_mm", "antinode_velocity_m_per_s"}, {});
  v.numbers("amplitude_over_diameter", a.amplitudes_over_diameter,
            {.help = "antinode amplitudes as parts of the conductor's diameter, one or a list", .above = 0});
  v.numbers("antinode_amplitude_mm", a.antinode_amplitudes,
            {.help = "antinode amplitudes, one or a list", .unit = units::mm, .above = 0});
  v.numbers("antinode_velocity_m_per_s", a.antinode_velocities,
            {.help = "velocity amplitudes of the antinode, one or a list", .unit = units::m_per_s, .above = 0});
  v.one_of({"tensions_rts", "tensions_kN"}, {});
  v.numbers("tensions_rts", a.tensions_rts,
            {.help = "tensions as parts of the rated strength, one or a list", .above = 0, .at_most = 1});
  v.numbers("tensions_kN", a.tensions, {.help = "tensions, one or a list", .unit = units::kN, .above = 0});
  v.choice("road", a.method, {.help = "how a point is computed"});
  v.choice("mode_shape", a.mode_shape,
           {.help = "the shape that the road \"quadrature\" goes over: the sine of a taut string, or the mode of the "
                    "span with its clamped ends"});
  v.tables("at", a.at, {.help = "single points beside the grid, each with a road of its own if wanted"});
  v.rows("bands_over_diameter", a.bands,
         {{{.help = "the smallest antinode amplitude over the diameter", .at_least = 0},
           {.help = "the largest one", .above = 0}}},
         {.help = "bands of amplitude over diameter that are fitted one by one, rows of smallest and largest"});
  v.table("periodic", a.periodic, {.help = "how the road \"periodic\" is solved"});
  v.table("foti_2018", a.simplified, {.help = "the numbers of the road \"foti-2018\""});
  v.table("bench", a.bench, {.help = "the test bench of the road \"transient\""});
  v.tables("energy_balance", a.energy_balances, {.help = "wind against self-damping of the bare conductor"});
}

}  // namespace strandyn::casefile
