#pragma once
/// \file One case from its scene to its summary: what `strandyn run` does between reading and writing.

#include "strandyn/casefile/acceptance.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// The file in the folder of a run that has not come to its end.
inline constexpr const char* checkpoint_name = "checkpoint.bin";
/// The file from which this case resumes: checkpoint.bin, or the finished points of a study.
const char* resumes_from(const casefile::Scene& scene);

struct CaseResult : Outcome {
  std::vector<casefile::Verdict> verdicts;  ///< of [accept]
};

/// Prepares the analysis and runs it. Throws what `prepare` throws, and ComputationError where nothing was computed; a
/// run that fails midway or is stopped comes back with what it has. `summary` is then whole: the contract's
/// summary.json.
CaseResult run_case(const casefile::Scene& scene, const Hooks& hooks = {});

/// What `strandyn describe` tells: the resolved scene in SI, what will be modelled, what it is expected to cost.
results::Value describe_case(const casefile::Scene& scene);

}  // namespace strandyn::study
