#pragma once
/// \file Modes across a span, counted as the case counts them, at an antinode of one; and the one nearest to a
/// frequency.

#include <vector>

#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/span/rest.hpp"

namespace strandyn::span {

/// The lowest modes across the span, in its plane: what "mode 12" counts. None for 0.
std::vector<solver::Mode> modes_across(const SpanAtRest& span, int count, const Stop& stop = {});

/// The mode across the span, in its plane, that is nearest to `frequency` [Hz]; its number is among those.
solver::Mode mode_near(const SpanAtRest& span, double frequency, const Stop& stop = {});

/// The shape with a deflection of 1 m at its largest antinode away from the ends: next to a clamp the crest of a mode
/// is a little higher.
system::Vector unit_antinode(const SpanAtRest& span, const solver::Mode& mode);

/// What a `modes` analysis tells of one mode.
struct ModeRow {
  std::size_t number = 0;  ///< from 1, among those that are counted
  double frequency = 0;    ///< [Hz]
  int half_waves = 0;
  std::string kind;       ///< "in-plane", ...
  double modal_mass = 0;  ///< [kg] ([kg m^2])
};
template <class V>
void members(V& v, ModeRow& m) {
  v.value("number", m.number,
          {.what = "its place from the lowest mode up: among those across the span in its plane, or among all where "
                   "modes near a frequency, of a span in space or of a frame are asked for; 0: rigid"});
  v.value("frequency_Hz", m.frequency, {.what = "the natural frequency"});
  v.value("half_waves", m.half_waves, {.what = "half-waves along the span"});
  v.value("kind", m.kind,
          {.what = "in-plane, out-of-plane, axial, torsional, or rigid: the chain in one piece, which nothing holds"});
  v.value("modal_mass_kg", m.modal_mass, {.what = "the modal mass of a shape that is 1 where it is largest"});
}
std::vector<ModeRow> rows_of(const SpanAtRest& span, const std::vector<solver::Mode>& modes);
/// Shapes of all modes, one row per node: displacements along x, y, z where the chain has them.
results::Table shapes_of(const SpanAtRest& span, const std::vector<solver::Mode>& modes);

}  // namespace strandyn::span
