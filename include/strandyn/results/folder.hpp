#pragma once
/// \file The output folder and the files in it. Every failure is a FileError that names the path and the cause.

#include <filesystem>
#include <string>
#include <string_view>

namespace strandyn::results {

/// Creates the folder and its parents where they are missing, and makes sure that files can be written into it: a run
/// learns at its start, not at its end, that its results have no place. Takes away what a killed program has left half
/// written there.
void create_folder(const std::filesystem::path& path);

/// Replaces the file in one step (temporary file beside it, flushed to disk, renamed): after a crash or on a full disk
/// there is the old file or the new one, never half of one. `content` may be binary.
void write_file(const std::filesystem::path& path, std::string_view content);

/// The whole file.
std::string read_file(const std::filesystem::path& path);

}  // namespace strandyn::results
