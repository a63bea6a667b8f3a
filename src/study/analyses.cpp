#include <algorithm>

#include "entries.hpp"
#include "room.hpp"

namespace strandyn::study {

void Cost::add(const Cost& part) {
  steps += part.steps;
  rejected_steps += part.rejected_steps;
  order_one_steps += part.order_one_steps;
  residual_evaluations += part.residual_evaluations;
  jacobian_evaluations += part.jacobian_evaluations;
  section_evaluations += part.section_evaluations;
  section_sweeps += part.section_sweeps;
  newton_iterations += part.newton_iterations;
}

std::unique_ptr<Analysis> prepare(const casefile::Scene& scene) {
  // A study chooses for each tension and each point by itself.
  if (scene.accuracy && scene.is<casefile::SweepAnalysis>()) return prepare_accurate_sweep(scene);
  if (scene.accuracy && !scene.is<casefile::SelfDampingAnalysis>()) return prepare_accurate(scene);
  refuse_without_room(scene);
  return std::ranges::find(entries, casefile::word_of(scene.analysis), &Entry::word)->prepare(scene);
}

}  // namespace strandyn::study
