#pragma once
/// \file Near words, for messages that guess what was meant.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace strandyn {

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidates, nearest to `word` first; equal ones keep their order.
std::vector<std::string> nearest_first(std::string_view word, std::vector<std::string> candidates);

/// The nearest candidate, if it is near enough to be a slip of the pen: a third of the word's letters, at least two.
std::optional<std::string> near_word(std::string_view word, const std::vector<std::string>& candidates);

/// "`a`, `b`, `c`"
std::string list_words(const std::vector<std::string>& words, char quote = '`');

}  // namespace strandyn
