#pragma once
/// \file `type = "sweep"`: the steady response through one resonance.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/casefile/periodic.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

/// Through the resonance nearest to the frequency of the drive, at its amplitude.
struct SweepAnalysis {
  static constexpr std::string_view word = "sweep";
  static constexpr bool needs_span = true;
  static constexpr bool needs_mass = true;
  static constexpr bool needs_drive = true;
  double relative_width = 0.02;          ///< [-] how far below and above the linear frequency; instead:
  std::optional<double> from, to;        ///< [Hz] both
  std::optional<double> frequency_step;  ///< [Hz] largest; empty: a fortieth of the way
  double swing_step = 0.1;               ///< [-] largest change of the response between two points, in parts of itself
  int backbone_points = 5;               ///< resonances up to the peak's amplitude
  PeriodicKeys periodic;
};

template <class V>
void keys(V& v, SweepAnalysis& a) {
  v.number("relative_width", a.relative_width,
           {.help = "how far the sweep reaches below and above the linear frequency, as a part of it",
            .above = 0,
            .below = 1});
  v.number("from_Hz", a.from,
           {.help = "the frequency where the sweep begins (from relative_width unless given)",
            .unit = units::Hz,
            .above = 0});
  v.number("to_Hz", a.to,
           {.help = "the frequency where it ends; it may lie below from_Hz", .unit = units::Hz, .above = 0});
  v.number(
      "frequency_step_Hz", a.frequency_step,
      {.help = "the largest step of frequency (a fortieth of the way unless given)", .unit = units::Hz, .above = 0});
  v.number(
      "swing_step", a.swing_step,
      {.help = "the largest change of the response from point to point, as a part of it", .above = 0, .at_most = 1});
  v.number(
      "backbone_points", a.backbone_points,
      {.help = "the number of resonances that are solved, up to the amplitude that the drive reaches", .at_least = 1});
  v.table("periodic", a.periodic, {.help = "how the periodic response is solved"});
}

}  // namespace strandyn::casefile
