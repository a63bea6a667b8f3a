#pragma once
/// \file What comes with the program: its cases, its documentation.

#include <filesystem>
#include <string>

namespace strandyn::app {

/// `name` ("cases") of the working folder, what was installed with this program below its prefix (`installed`, as
/// "share/strandyn/cases"), or what it was built beside.
std::filesystem::path shipped(const std::string& name, const std::string& installed);

}  // namespace strandyn::app
