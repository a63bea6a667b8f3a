#pragma once
/// \file One case from its scene to its summary: what `strandyn run` does between reading and writing.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::study {

/// How the caller takes part in a run.
struct Hooks {
  std::function<bool()> stop;                                       ///< true: end early, keep what there is
  std::function<void(double fraction, std::string_view)> progress;  ///< how far, in words
  std::function<void(std::string_view)> announce = {};              ///< what is going to be integrated, before it is
  /// Where a study of many points keeps the finished ones, and a long run its checkpoints; empty: nowhere.
  std::filesystem::path folder = {};
  bool resume = false;  ///< go on from the checkpoint in `folder`, if there is one
};

/// The file in the folder of a run that has not come to its end.
inline constexpr const char* checkpoint_name = "checkpoint.bin";

struct NamedTable {
  std::string file;  ///< "cycles.csv"
  results::Table table;
};

struct CaseResult {
  ExitCode exit_code = ExitCode::done;
  nlohmann::ordered_json summary;  ///< the contract's summary.json
  std::vector<NamedTable> tables;
  std::vector<casefile::Verdict> verdicts;  ///< of [accept]
  std::string message;                      ///< why exit_code is not `done`; empty otherwise
  bool ended_early = false;                 ///< interrupted or failed midway: a checkpoint may still serve
};

/// Runs the analysis. Throws InputError for what the scene asks and this version cannot do, and ComputationError where
/// nothing was computed; a run that fails midway or is stopped comes back with what it has.
CaseResult run_case(const casefile::Scene& scene, const Hooks& hooks = {});

/// What `strandyn describe` tells: the resolved scene in SI, what will be modelled, what it is expected to cost.
nlohmann::ordered_json describe_case(const casefile::Scene& scene);

}  // namespace strandyn::study
