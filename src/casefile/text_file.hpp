#pragma once
/// \file The text of a file, whole.

#include <filesystem>
#include <string>

namespace strandyn::casefile {

/// Throws FileError where it is a folder or cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace strandyn::casefile
