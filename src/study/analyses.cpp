#include <algorithm>
#include <array>

#include "entries.hpp"

namespace strandyn::study {

namespace {

struct Entry {
  std::string_view word;
  Prepare* prepare;
};

/// All analyses there are.
constexpr std::array entries = {Entry{casefile::SectionAnalysis::word, prepare_section},
                                Entry{casefile::AxialTorsionAnalysis::word, prepare_axial_torsion},
                                Entry{casefile::StaticAnalysis::word, prepare_static},
                                Entry{casefile::ModesAnalysis::word, prepare_modes},
                                Entry{casefile::DecayAnalysis::word, prepare_decay},
                                Entry{casefile::ForcedAnalysis::word, prepare_forced},
                                Entry{casefile::TransientAnalysis::word, prepare_transient},
                                Entry{casefile::SweepAnalysis::word, prepare_sweep},
                                Entry{casefile::SelfDampingAnalysis::word, prepare_self_damping}};

}  // namespace

std::unique_ptr<Analysis> prepare(const casefile::Scene& scene) {
  return std::ranges::find(entries, casefile::word_of(scene.analysis), &Entry::word)->prepare(scene);
}

}  // namespace strandyn::study
