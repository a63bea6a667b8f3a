#include "strandyn/conductor/catalogue.hpp"

#include <algorithm>
#include <cctype>

#include "strandyn/core/near_words.hpp"

namespace strandyn::conductor {
namespace {

/// Small letters, one dash between words.
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool gap = c == ' ' || c == '_' || c == '-' || c == '/' || c == '\t';
    if (!gap) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (gap && !text.empty() && text.back() != '-') text += '-';
  }
  while (text.ends_with('-')) text.pop_back();
  return text;
}

/// The title of an entry, plain. The files write it on a line of its own.
std::string title_of(const CatalogueEntry& entry) {
  constexpr std::string_view key = "title = \"";
  const std::size_t at = entry.text.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = entry.text.substr(at + key.size());
  return plain(rest.substr(0, rest.find('"')));
}

/// "bluebird-acss" as "acss-bluebird": makers write the type behind a stroke.
std::string last_word_first(const std::string& plain_name) {
  const std::size_t dash = plain_name.rfind('-');
  return dash == std::string::npos ? plain_name : plain_name.substr(dash + 1) + '-' + plain_name.substr(0, dash);
}

std::string first_word(const std::string& plain_name) {
  return plain_name.substr(0, plain_name.find('-'));
}

}  // namespace

const CatalogueEntry* find_entry(std::string_view name) {
  const std::string wanted = plain(name);
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name == wanted || entry.name == last_word_first(wanted)) return &entry;
  }
  for (const CatalogueEntry& entry : catalogue()) {
    const std::string title = title_of(entry);
    if (wanted == title || wanted == first_word(title) + '-' + std::string(entry.name)) return &entry;
  }
  return nullptr;
}

const CatalogueEntry* near_entry(std::string_view name) {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue()) names.emplace_back(entry.name);
  const std::string wanted = plain(name);
  const std::string without_type = wanted.substr(std::min(wanted.find('-') + 1, wanted.size()));
  for (const std::string& word : {wanted, without_type}) {
    if (const auto near = near_word(word, names)) return find_entry(*near);
  }
  return nullptr;
}

std::string case_table(const CatalogueEntry& entry) {
  constexpr std::string_view layer = "[[layer]]";
  std::string text;
  bool opened = false;
  for (std::size_t begin = 0; begin < entry.text.size();) {
    const std::size_t end = std::min(entry.text.find('\n', begin), entry.text.size());
    const std::string_view line = entry.text.substr(begin, end - begin);
    if (!opened && !line.starts_with('#')) {  // the comment above the table speaks of it
      text += "[conductor]\n";
      opened = true;
    }
    text +=
        line.starts_with(layer) ? "[[conductor.layer]]" + std::string(line.substr(layer.size())) : std::string(line);
    text += '\n';
    begin = end + 1;
  }
  return text;
}

}  // namespace strandyn::conductor
