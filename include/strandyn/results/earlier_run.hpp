#pragma once
/// \file What an earlier run left in a folder that another one is to fill: a folder never mixes the results of two.

#include <filesystem>
#include <string>
#include <vector>

namespace strandyn::results {

/// The files that the summary of the folder names, the drawings of its figures, its page. Empty where there is none.
std::vector<std::string> files_of_earlier_run(const std::filesystem::path& folder);

/// Removes those of the earlier run that are not among `written`.
void take_away(const std::filesystem::path& folder, const std::vector<std::string>& earlier,
               const std::vector<std::string>& written);

}  // namespace strandyn::results
