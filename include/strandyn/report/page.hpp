#pragma once
/// \file A results folder as one page that needs nothing beside it.

#include <filesystem>

namespace strandyn::report {

/// Reads summary.json, which must be there, and the tables that its figures and shown tables name. Writes report.html
/// and each figure as an SVG file of its own into the folder; returns the path of the page. Throws FileError where
/// there is no summary or a file cannot be written, InputError where a file is broken or a figure or a shown table asks
/// for a table or a column that is not there.
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace strandyn::report
