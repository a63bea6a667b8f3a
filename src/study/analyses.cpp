#include <algorithm>

#include "entries.hpp"
#include "room.hpp"

namespace strandyn::study {

std::unique_ptr<Analysis> prepare(const casefile::Scene& scene) {
  refuse_without_room(scene);
  return std::ranges::find(entries, casefile::word_of(scene.analysis), &Entry::word)->prepare(scene);
}

}  // namespace strandyn::study
