#pragma once
/// \file A tree of results as JSON text, and back.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "strandyn/results/value.hpp"

namespace strandyn::results {

/// `indent` spaces a level; below zero on one line. Numbers have the fewest digits that read back to the same bits.
std::string to_text(const Value& value, int indent = 2);

/// Throws InputError that says where the text is no JSON; `name` stands for the file.
Value from_text(std::string_view text, const std::string& name);
/// Nothing where the text is no JSON.
std::optional<Value> from_line(std::string_view text);

/// Replaces the file in one step. A number that is not finite is refused with its place in the document
/// (`cycles[3].kinetic_J`): JSON has no NaN, and a silent null would read like a result that was never asked for.
void write_json(const std::filesystem::path& path, const Value& value);

}  // namespace strandyn::results
