#pragma once
/// \file The table of analyses: the word of each and the function that prepares it.

#include <array>

#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

using Prepare = std::unique_ptr<Analysis>(const casefile::Scene& scene);

Prepare prepare_section, prepare_axial_torsion, prepare_static, prepare_modes, prepare_decay, prepare_forced,
    prepare_transient, prepare_sweep, prepare_self_damping;

struct Entry {
  std::string_view word;
  Prepare* prepare;
};

inline constexpr std::array entries = {Entry{casefile::SectionAnalysis::word, prepare_section},
                                       Entry{casefile::AxialTorsionAnalysis::word, prepare_axial_torsion},
                                       Entry{casefile::StaticAnalysis::word, prepare_static},
                                       Entry{casefile::ModesAnalysis::word, prepare_modes},
                                       Entry{casefile::DecayAnalysis::word, prepare_decay},
                                       Entry{casefile::ForcedAnalysis::word, prepare_forced},
                                       Entry{casefile::TransientAnalysis::word, prepare_transient},
                                       Entry{casefile::SweepAnalysis::word, prepare_sweep},
                                       Entry{casefile::SelfDampingAnalysis::word, prepare_self_damping}};
static_assert(entries.size() == std::variant_size_v<casefile::Analysis>, "one row for each analysis of a case");

}  // namespace strandyn::study
