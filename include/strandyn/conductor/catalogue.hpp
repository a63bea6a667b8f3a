#pragma once
/// \file The catalogue of conductors: data files in the syntax of a case file's [conductor] table, embedded at build
/// time.

#include <string>
#include <string_view>
#include <vector>

namespace strandyn::conductor {

/// One data file. The text is what a user would write below [conductor]; `casefile` reads both with the same code.
struct CatalogueEntry {
  std::string_view name;  ///< as in `catalogue = "..."`
  std::string_view text;  ///< TOML
};

/// All entries, sorted by name.
const std::vector<CatalogueEntry>& catalogue();

/// The entry that a name means as people write it: letters large or small, blanks, dashes or strokes between the words,
/// the type in front or the whole title ("Drake", "ACSR Drake", "acsr drake 26/7"). None: nullptr. "ACSS Drake" is
/// another conductor and finds nothing.
const CatalogueEntry* find_entry(std::string_view name);

/// The entry whose name is nearest to a misspelt one, the type in front or not; nullptr where none is near.
const CatalogueEntry* near_entry(std::string_view name);

/// The entry as the table [conductor] of a case file.
std::string case_table(const CatalogueEntry& entry);

}  // namespace strandyn::conductor
