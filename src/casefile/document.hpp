#pragma once
/// \file The TOML of a case: parsed, with the overrides of the command line in it and the place of every key noted.

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/casefile/source.hpp"

namespace strandyn::casefile {

struct Document {
  toml::table root;
  Source source;
};

/// Throws InputError where the text is not TOML, or an override leads nowhere.
Document parse_document(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);

/// A key as a key path spells it: in quotes unless it is a bare TOML key.
std::string spell_key(std::string_view key);

}  // namespace strandyn::casefile
