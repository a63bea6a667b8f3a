#pragma once
/// \file What is looked at before a text goes to the TOML library: the library parses recursively, and some texts that
/// are no TOML make it stop the program instead of saying so.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace strandyn::casefile {

inline constexpr std::size_t most_bytes = 64U << 20U;  ///< of a case file
inline constexpr int most_key_parts = 16;              ///< of a dotted key
inline constexpr int most_levels = 32;                 ///< of brackets and braces

struct Unreadable {
  std::size_t line = 1, column = 1;
  std::string wrong, right;
};

/// The first thing that the library must not see, if there is any.
std::optional<Unreadable> find_unreadable(std::string_view text);

}  // namespace strandyn::casefile
