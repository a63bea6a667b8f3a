#include <algorithm>
#include <array>

#include "entries.hpp"

namespace strandyn::study {

using casefile::AnalysisType;

namespace {

struct Entry {
  AnalysisType word;
  Prepare* prepare;
};

/// All analyses there are.
constexpr std::array entries = {Entry{AnalysisType::section, prepare_section},
                                Entry{AnalysisType::axial_torsion, prepare_axial_torsion},
                                Entry{AnalysisType::static_, prepare_static},
                                Entry{AnalysisType::modes, prepare_modes},
                                Entry{AnalysisType::decay, prepare_decay},
                                Entry{AnalysisType::forced, prepare_forced},
                                Entry{AnalysisType::transient, prepare_transient},
                                Entry{AnalysisType::sweep, prepare_sweep},
                                Entry{AnalysisType::self_damping, prepare_self_damping}};

}  // namespace

std::unique_ptr<Analysis> prepare(const casefile::Scene& scene) {
  return std::ranges::find(entries, scene.analysis.type, &Entry::word)->prepare(scene);
}

}  // namespace strandyn::study
