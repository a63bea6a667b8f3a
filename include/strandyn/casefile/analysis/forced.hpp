#pragma once
/// \file `type = "forced"`: vibration under harmonic loads, for a number of cycles or until it is steady.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class Until { steady };
constexpr auto words_of(Until) {
  return std::array{Named{Until::steady, "steady"}};
}

struct ForcedAnalysis {
  static constexpr std::string_view word = "forced";
  static constexpr bool needs_span = true;
  static constexpr bool needs_mass = true;
  static constexpr bool needs_drive = true;
  std::optional<int> cycles;  ///< this or
  std::optional<Until> until;
};

template <class V>
void keys(V& v, ForcedAnalysis& a) {
  v.one_of({"cycles", "until"}, {.required = true});
  v.number("cycles", a.cycles, {.help = "the number of cycles", .at_least = 1});
  v.choice("until", a.until, {.help = "what ends the run"});
}

}  // namespace strandyn::casefile
