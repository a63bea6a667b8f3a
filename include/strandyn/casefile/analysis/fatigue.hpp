#pragma once
/// \file `type = "fatigue"`: what recorded bending amplitudes have done to a conductor at its clamp.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

struct FatigueAnalysis {
  static constexpr std::string_view word = "fatigue";
  static constexpr bool needs_conductor = true;
  std::optional<double> tension;            ///< [N] this, or
  std::optional<double> tension_rts;        ///< [-]
  std::optional<std::string> matrix_file;   ///< beside the case: this, or
  std::optional<std::string> history_file;  ///< beside the case
  std::optional<double> recorded;           ///< [h] that the matrix stands for
  double distance = 0.089;                  ///< [m] from the last point of contact
};

template <class V>
void keys(V& v, FatigueAnalysis& a) {
  v.one_of({"tension_kN", "tension_rts"}, {.required = true});
  v.number("tension_kN", a.tension, {.help = "the tension", .unit = units::kN, .above = 0});
  v.number("tension_rts", a.tension_rts,
           {.help = "the tension as a part of the rated strength", .above = 0, .at_most = 1});
  v.one_of({"matrix_file", "history_file"}, {.required = true});
  v.text("matrix_file", a.matrix_file,
         {.help = "the name of a csv file, beside the case, with the columns bending_amplitude_um (peak to peak), "
                  "frequency_Hz and cycles, as line recorders write them"});
  v.text("history_file", a.history_file,
         {.help = "the name of a csv file, beside the case, with the columns time_s and deflection_um, read at the "
                  "distance from the clamp; its cycles are counted by rainflow"});
  v.number("recorded_hours", a.recorded,
           {.help = "the time that the matrix stands for, gaps between recordings included", .above = 0});
  v.number(
      "distance_mm", a.distance,
      {.help = "the distance from the last point of contact at which it was recorded", .unit = units::mm, .above = 0});
}

}  // namespace strandyn::casefile
