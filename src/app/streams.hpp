#pragma once
/// \file The doors to the shell. Results go to standard output, and a word that cannot be written there is an error;
/// words for people go to standard error, and where nobody can read them the work goes on.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "strandyn/core/error.hpp"

namespace strandyn::app {

/// Before any file is opened: a stream that is closed must not become a results file, and a reader that has gone away
/// (`| head`) is found out by writing, not by a signal that would end a run in its midst.
void guard_streams();

/// To standard output, as it is. Throws FileError; with an empty text where the reader has gone away.
void print_raw(std::string_view text);

/// To standard error, as far as it can be written. Never throws.
void tell_raw(std::string_view text) noexcept;

/// Without what would steer a terminal: titles and file names are the user's. Control characters but tab and line end
/// become \x1b and the like.
std::string harmless(std::string_view text);

template <class... Arguments>
void print(fmt::format_string<Arguments...> words, Arguments&&... arguments) {
  print_raw(harmless(fmt::format(words, std::forward<Arguments>(arguments)...)));
}

template <class... Arguments>
void tell(fmt::format_string<Arguments...> words, Arguments&&... arguments) {
  tell_raw(harmless(fmt::format(words, std::forward<Arguments>(arguments)...)));
}

}  // namespace strandyn::app
