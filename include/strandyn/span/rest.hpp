#pragma once
/// \file A span in its static state, ready to be set in motion; and what it says of itself there.

#include <array>
#include <optional>

#include "strandyn/build/span.hpp"
#include "strandyn/results/table.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::span {

/// At rest under its dead loads; virgin sections, bent in one step from the straight.
struct SpanAtRest {
  explicit SpanAtRest(build::BuiltSpan built);
  /// Brings the loads that do not change to their full size: what a vibration is about.
  void apply_static_loads();

  build::BuiltSpan built;
  system::System system;
  system::Vector u;
};

using Components = std::array<double, 3>;  ///< along x, y, z

/// How a hanging span hangs.
struct Rest {
  double unstressed_length = 0;                                               ///< [m]
  std::optional<double> sag{}, catenary_sag{}, swing{};                       ///< [m]
  std::optional<double> horizontal_tension{}, catenary_horizontal_tension{};  ///< [N]
};
/// Nothing where the span does not hang.
std::optional<Rest> rest_of(const SpanAtRest& span);

template <class V>
void members(V& v, Rest& r) {
  v.value("unstressed_length_m", r.unstressed_length, {.what = "the length of the span without tension"});
  v.value("sag_m", r.sag, {.what = "the sag below the chord", .shown = "sag"});
  v.value("catenary_sag_m", r.catenary_sag, {.what = "the sag of a flexible cable"});
  v.value("swing_m", r.swing, {.what = "how far a steady wind swings it out, along z", .shown = "swing in the wind"});
  v.value("horizontal_tension_N", r.horizontal_tension,
          {.what = "the horizontal component of the tension", .shown = "horizontal tension"});
  v.value("catenary_horizontal_tension_N", r.catenary_horizontal_tension, {.what = "that of a flexible cable"});
}

/// What a support does to the chain.
struct Reaction {
  Components force{}, moment{};  ///< [N], [N m]
};
template <class V>
void members(V& v, Reaction& r) {
  v.value("force_N", r.force, {.what = "the force on the end of the chain"});
  v.value("moment_N_m", r.moment, {.what = "the moment on it"});
}
struct Reactions {
  Reaction left, right;
};
template <class V>
void members(V& v, Reactions& r) {
  v.record("left", r.left, {.what = "of the left support"});
  v.record("right", r.right, {.what = "of the right support"});
}

/// Under `load_factor` of the loads.
Reactions reactions_of(const SpanAtRest& span, double load_factor);
Components right_end_of(const SpanAtRest& span);  ///< [m]
/// One row per node: arc length, place, rotation.
results::Table shape_of(const SpanAtRest& span);

/// [m] of the longest element.
double longest_element(const SpanAtRest& span);

}  // namespace strandyn::span
