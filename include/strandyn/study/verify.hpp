#pragma once
/// \file Runs every case that carries an [accept] table: what `strandyn verify` prints side by side.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "strandyn/casefile/acceptance.hpp"

namespace strandyn::study {

struct VerifiedCase {
  std::string name;  ///< path below the folder, without ".toml"
  std::string title;
  std::vector<casefile::Verdict> verdicts;
  std::string error;  ///< why it could not be run; empty otherwise

  bool passed() const;
};

/// The cases below `folder` with an [accept] table whose name contains one of `names`, or all if there are none;
/// sorted. Files of the folder `refused` are left out. The cases run on all cores; `started` hears the name of each
/// before it runs, from one thread at a time.
std::vector<VerifiedCase> verify_cases(const std::filesystem::path& folder, const std::vector<std::string>& names,
                                       const std::function<void(const std::string&)>& started);

}  // namespace strandyn::study
