#pragma once
/// \file JSON Schema (draft 2020-12) of a case file, for editors: types, units, defaults, bounds, choices and help,
/// from the same declarations that read the file.

#include <string>

namespace strandyn::casefile {

std::string case_schema();

/// The same as a page of Markdown for people: a table of keys for each table of the file.
std::string key_reference();

}  // namespace strandyn::casefile
