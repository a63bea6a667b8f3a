#pragma once
/// \file `type = "transient"`: anything over time.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class Start { loaded, unloaded };
constexpr auto words_of(Start) {
  return std::array{Named{Start::loaded, "loaded"}, Named{Start::unloaded, "unloaded"}};
}

struct TransientAnalysis {
  static constexpr std::string_view word = "transient";
  static constexpr bool needs_span = true;
  static constexpr bool needs_mass = true;
  double duration = 0;               ///< [s]
  std::optional<Start> start;        ///< empty: loaded, and the run says so where it matters
  std::vector<double> probes;        ///< [m] from the left support; empty: the right end and the loaded points
  std::optional<double> rows_every;  ///< [s] empty: every step of a run that is not long
};

template <class V>
void keys(V& v, TransientAnalysis& a) {
  v.number("duration_s", a.duration,
           {.help = "the time that is integrated", .unit = units::s, .above = 0, .required = true});
  v.choice("start", a.start,
           {.help = "whether what loads and motions have at t = 0 is part of the state of rest (loaded, also where the "
                    "key is missing), or acts suddenly"});
  v.numbers(
      "probes_m", a.probes,
      {.help = "places whose motion is written, along the span (the right end and the loaded points unless given)",
       .unit = units::m,
       .at_least = 0});
  v.number("rows_every_s", a.rows_every,
           {.help = "the time between the rows of histories.csv and energies.csv (every step unless given, of a run of "
                    "more than 40 000 steps 20 000 to 40 000 of them)",
            .unit = units::s,
            .above = 0});
}

}  // namespace strandyn::casefile
