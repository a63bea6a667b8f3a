#pragma once
/// \file The table of analyses: the word of each, the function that prepares it, and what its summary says.

#include <array>

#include "strandyn/results/reference.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

using Prepare = std::unique_ptr<Analysis>(const casefile::Scene& scene);

Prepare prepare_section, prepare_axial_torsion, prepare_static, prepare_modes, prepare_decay, prepare_forced,
    prepare_transient, prepare_sweep, prepare_self_damping, prepare_tradeoff, prepare_damper, prepare_fatigue;

/// The members of the summary that are the analysis' own.
using Notes = std::vector<results::MemberNote>();

Notes notes_of_frame, notes_of_section, notes_of_axial_torsion, notes_of_static, notes_of_modes, notes_of_vibration,
    notes_of_decay_analysis, notes_of_transient, notes_of_sweep, notes_of_self_damping, notes_of_tradeoff,
    notes_of_damper, notes_of_fatigue;

/// The analysis with a mesh, a step and points that meet the accuracy asked for, and an estimate of its error.
Prepare prepare_accurate;
Notes notes_of_accuracy;
/// The same of a sweep.
Prepare prepare_accurate_sweep;
Notes notes_of_accurate_sweep;

/// `program` of every summary: what has computed it.
results::Value program_of_summaries();
/// Where a tradeoff keeps the summaries of its settings.
inline constexpr const char* settings_folder = "settings";

struct Entry {
  std::string_view word;
  Prepare* prepare;
  Notes* notes;
};

inline constexpr std::array entries = {
    Entry{casefile::SectionAnalysis::word, prepare_section, notes_of_section},
    Entry{casefile::AxialTorsionAnalysis::word, prepare_axial_torsion, notes_of_axial_torsion},
    Entry{casefile::StaticAnalysis::word, prepare_static, notes_of_static},
    Entry{casefile::ModesAnalysis::word, prepare_modes, notes_of_modes},
    Entry{casefile::DecayAnalysis::word, prepare_decay, notes_of_decay_analysis},
    Entry{casefile::ForcedAnalysis::word, prepare_forced, notes_of_vibration},
    Entry{casefile::TransientAnalysis::word, prepare_transient, notes_of_transient},
    Entry{casefile::SweepAnalysis::word, prepare_sweep, notes_of_sweep},
    Entry{casefile::SelfDampingAnalysis::word, prepare_self_damping, notes_of_self_damping},
    Entry{casefile::TradeoffAnalysis::word, prepare_tradeoff, notes_of_tradeoff},
    Entry{casefile::DamperAnalysis::word, prepare_damper, notes_of_damper},
    Entry{casefile::FatigueAnalysis::word, prepare_fatigue, notes_of_fatigue}};
static_assert(entries.size() == std::variant_size_v<casefile::Analysis>, "one row for each analysis of a case");

}  // namespace strandyn::study
