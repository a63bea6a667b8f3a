#pragma once
/// \file The verbs of the command line. Each returns the exit code; errors travel as exceptions to main.

#include <filesystem>
#include <string>
#include <vector>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::app {

struct RunArguments {
  std::filesystem::path file;
  std::filesystem::path out;  ///< empty: results/<case name>
  std::vector<std::string> overrides;
  bool json = false;
  bool quiet = false;
  bool resume = false;  ///< from the checkpoint in the results folder
  bool report = false;  ///< make the page, too
  std::string shard;    ///< I/N: a part of a study; empty: all of it
};

struct MergeArguments {
  std::vector<std::filesystem::path> folders;  ///< of the shards
  RunArguments run;                            ///< where and how to say the results; no case file
};

struct VerifyArguments {
  std::filesystem::path folder;    ///< of the cases; empty: ./cases, or those of the source tree
  std::vector<std::string> names;  ///< parts of names; empty: all. A first `extremes` asks for the table of hard cases
  bool json = false;
  bool markdown = false;
};

/// Reads the case and prints its notes to standard error.
casefile::Scene read_noted(const std::filesystem::path& file, const std::vector<std::string>& overrides);

ExitCode run(const RunArguments& arguments);
/// Puts the shards of a study together.
ExitCode merge(const MergeArguments& arguments);
/// Of `run` and `merge`: the run of a scene into a folder that is there, its results written and said.
ExitCode run_into(const std::filesystem::path& folder, const casefile::Scene& scene, const RunArguments& arguments,
                  const study::Hooks& how);
ExitCode check(const RunArguments& arguments);
ExitCode describe(const RunArguments& arguments);
/// The catalogue as a table, or one conductor of it as the table [conductor] of a case.
ExitCode conductors(const std::string& name);
/// The table [conductor] of a CSV file of wires per layer.
ExitCode import_conductor(const std::filesystem::path& csv);
enum class SchemaForm { json, results, keys };
ExitCode schema(SchemaForm form);
ExitCode verify(const VerifyArguments& arguments);
/// Hard cases, each with the bound of physics that must hold; `names` after the first select rows.
ExitCode verify_extremes(const VerifyArguments& arguments);
ExitCode report(const std::filesystem::path& folder);

}  // namespace strandyn::app
