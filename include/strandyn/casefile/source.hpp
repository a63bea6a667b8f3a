#pragma once
/// \file Where each key of a case came from, and the one form of an input error:
///
///     cases/x.toml:12:3: span.length_m = -4: must be above 0; give the distance between the supports in metres
///
/// place, key path, the text found, what is wrong, what would be right.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace strandyn::casefile {

/// What a reader of the case remembers of its text. Key paths look like `load[0].at_m`.
struct Source {
  struct Entry {
    std::string place;        ///< "file:line:column", or "--set key=value"
    std::string text;         ///< the value as written; empty for a table and for what spans several lines
    bool overridden = false;  ///< came from --set
  };

  std::string file;
  std::map<std::string, Entry, std::less<>> entries;
  /// Of the numbers in lists, which are no entries: there may be a million. Dear; for refusals.
  std::function<std::optional<Entry>(std::string_view key_path)> find_element = {};

  const Entry* find(std::string_view key_path) const;
  /// The entry, or the element of a list.
  std::optional<Entry> look_up(std::string_view key_path) const;
  /// Place of the key, or of the nearest table around it, or the top of the file.
  std::string place(std::string_view key_path) const;
};

/// Key path one level up: `load[0].at_m` -> `load[0]` -> `load` -> empty.
std::string_view parent_path(std::string_view key_path);

/// Throws the InputError of a key; also for what turns out wrong later, when the model is built.
[[noreturn]] void refuse(const Source& source, std::string_view key_path, std::string_view wrong,
                         std::string_view right);

}  // namespace strandyn::casefile
