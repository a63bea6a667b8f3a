#pragma once
/// \file Wires per layer from a CSV file, as the table [conductor] of a case.
///
///     wires,diameter_mm,metal,lay_ratio
///     1,3.45,ST6C,
///     6,3.45,ST6C,-20
///     10,4.44,AL1,13
///
/// One line per layer, core first. The columns are keys of [[conductor.layer]]; `metal` stands for young_GPa, poisson
/// and density_kg_per_m3 of a grade (conductor/metals.hpp), and what a line gives itself wins. An empty cell gives
/// nothing. Blanks and lines that begin with `#` are skipped; semicolons may separate the cells.

#include <filesystem>
#include <string>

namespace strandyn::casefile {

/// The table, which a case takes as it is, and `conductor.file` too. Throws FileError where the file cannot be read,
/// InputError with its line and column where the strand is none.
std::string import_wires(const std::filesystem::path& csv);

/// The same from a text; `name` stands for the file in messages and in the table.
std::string import_wires_text(const std::string& text, const std::string& name);

}  // namespace strandyn::casefile
