#pragma once
/// \file The catalogue of conductors: data files in the syntax of a case file's [conductor] table, embedded at build
/// time.

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

}  // namespace strandyn::conductor
