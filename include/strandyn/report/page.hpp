#pragma once
/// \file A results folder as one page that needs nothing beside it.

#include <filesystem>

namespace strandyn::report {

/// Reads summary.json, which must be there, and cycles.csv, dissipation_profile.csv, loop.csv, modes.csv where they
/// are. Writes report.html and each plot as an SVG file of its own into the folder; returns the path of the page.
/// Throws FileError where a file cannot be read or written, InputError where one is broken.
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace strandyn::report
