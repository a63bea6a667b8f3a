#include "strandyn/casefile/source.hpp"

#include <fmt/format.h>

#include "strandyn/core/error.hpp"

namespace strandyn::casefile {

const Source::Entry* Source::find(std::string_view key_path) const {
  const auto entry = entries.find(key_path);
  return entry == entries.end() ? nullptr : &entry->second;
}

std::optional<Source::Entry> Source::look_up(std::string_view key_path) const {
  if (const Entry* entry = find(key_path)) return *entry;
  return find_element && key_path.ends_with(']') ? find_element(key_path) : std::nullopt;
}

std::string Source::place(std::string_view key_path) const {
  for (std::string_view path = key_path; !path.empty(); path = parent_path(path)) {
    if (const auto entry = look_up(path)) return entry->place;
  }
  return file + ":1:1";
}

namespace {

/// As much of a value as one looks at; never half a letter.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 120;
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

}  // namespace

std::string_view parent_path(std::string_view key_path) {
  std::size_t cut = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < key_path.size(); ++i) {
    if (key_path[i] == '"') quoted = !quoted;
    if (!quoted && (key_path[i] == '.' || key_path[i] == '[')) cut = i;
  }
  return key_path.substr(0, cut);
}

void refuse(const Source& source, std::string_view key_path, std::string_view wrong, std::string_view right) {
  const std::optional<Source::Entry> entry = source.look_up(key_path);
  std::string found = entry ? shortened(entry->text) : "";
  if (!found.empty()) found = " = " + found;
  throw InputError(fmt::format("{}: {}{}: {}; {}", source.place(key_path), key_path, found, wrong, right));
}

}  // namespace strandyn::casefile
