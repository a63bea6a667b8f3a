#pragma once
/// \file The analyses that a case may choose from: this list is all that the reading of a case knows of them.
///
/// A type brings its `word`, its keys, and where something asks for it: needs_span, needs_mass, needs_conductor,
/// needs_drive (a harmonic load or motion), sets_tension, highest_mode(). To add one: a header of its own, a line here.

#include <variant>

#include "strandyn/casefile/analysis/axial_torsion.hpp"
#include "strandyn/casefile/analysis/damper.hpp"
#include "strandyn/casefile/analysis/decay.hpp"
#include "strandyn/casefile/analysis/fatigue.hpp"
#include "strandyn/casefile/analysis/forced.hpp"
#include "strandyn/casefile/analysis/modes.hpp"
#include "strandyn/casefile/analysis/section.hpp"
#include "strandyn/casefile/analysis/self_damping.hpp"
#include "strandyn/casefile/analysis/static.hpp"
#include "strandyn/casefile/analysis/sweep.hpp"
#include "strandyn/casefile/analysis/tradeoff.hpp"
#include "strandyn/casefile/analysis/transient.hpp"

namespace strandyn::casefile {

using Analysis = std::variant<SectionAnalysis, AxialTorsionAnalysis, StaticAnalysis, ModesAnalysis, DecayAnalysis,
                              ForcedAnalysis, TransientAnalysis, SweepAnalysis, SelfDampingAnalysis, TradeoffAnalysis,
                              DamperAnalysis, FatigueAnalysis>;

/// The word of the chosen one.
inline std::string_view word_of(const Analysis& analysis) {
  return std::visit([](const auto& a) { return a.word; }, analysis);
}

template <class V>
void keys(V& v, Analysis& a) {
  v.kinds("type", a, {.help = "what is computed", .required = true});
}

}  // namespace strandyn::casefile
