#pragma once
/// \file A case that is run, with its summary as tests read it: by paths.

#include <nlohmann/json.hpp>

#include "strandyn/results/json.hpp"
#include "strandyn/study/run_case.hpp"

namespace strandyn::test {

struct Run : study::CaseResult {
  nlohmann::ordered_json summary;  ///< in the place of the tree
};

inline Run run(const casefile::Scene& scene, const study::Hooks& hooks = {}) {
  study::CaseResult result = study::run_case(scene, hooks);
  nlohmann::ordered_json summary = nlohmann::ordered_json::parse(results::to_text(result.summary));
  return {std::move(result), std::move(summary)};
}

}  // namespace strandyn::test
