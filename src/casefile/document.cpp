#include "document.hpp"

#include <fmt/format.h>

#include <map>

#include "override.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::casefile {
namespace {

/// The texts that the nodes of a document come from, by name: the file, and each override.
using Texts = std::map<std::string, std::string, std::less<>>;

/// Offset in `text` of a place; TOML counts columns in code points.
std::size_t offset_of(std::string_view text, toml::source_position place) {
  std::size_t i = 0;
  for (toml::source_index line = 1; line < place.line; ++line) i = text.find('\n', i) + 1;
  for (toml::source_index column = 1; column < place.column && i < text.size(); ++column) {
    ++i;
    while (i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) ++i;
  }
  return i;
}

/// The value as written, where it stands on one line.
std::string text_of(const toml::node& node, const Texts& texts) {
  const toml::source_region& region = node.source();
  if (node.is_table() || node.is_array_of_tables() || region.begin.line != region.end.line) return {};
  const std::string_view text = texts.find(*region.path)->second;
  const std::size_t begin = offset_of(text, region.begin);
  std::string value(text.substr(begin, offset_of(text, region.end) - begin));
  while (!value.empty() && (value.back() == ' ' || value.back() == '\t')) value.pop_back();
  return value;
}

/// Notes the places below `node`. `key` is where the node's key stands; an element of an array has none.
void note_places(const toml::node& node, const toml::source_region* key, const std::string& path, const Texts& texts,
                 Source& source) {
  std::string first_child;
  const auto note_child = [&](const toml::node& child, const toml::source_region* child_key, const std::string& name) {
    note_places(child, child_key, name, texts, source);
    if (first_child.empty()) first_child = source.place(name);
  };
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, child] : *table) {
      note_child(child, &name.source(), path + (path.empty() ? "" : ".") + spell_key(name.str()));
    }
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) note_child(*array->get(i), nullptr, fmt::format("{}[{}]", path, i));
  }
  if (path.empty()) return;
  const toml::source_region& region = node.source();
  if (!region.path) {  // a table that an override made on its way to a key
    source.entries[path] = {.place = first_child, .text = {}, .overridden = true};
  } else if (is_override(*region.path)) {
    source.entries[path] = {.place = *region.path, .text = text_of(node, texts), .overridden = true};
  } else {
    const toml::source_position begin = key && key->begin ? key->begin : region.begin;
    source.entries[path] = {.place = fmt::format("{}:{}:{}", source.file, begin.line, begin.column),
                            .text = text_of(node, texts)};
  }
}

}  // namespace

std::string spell_key(std::string_view key) {
  const bool bare = !key.empty() && key.find_first_not_of(
                                        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789_-") == std::string_view::npos;
  return bare ? std::string(key) : fmt::format("\"{}\"", key);
}

Document parse_document(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  Document document;
  document.source.file = name;
  Texts texts{{name, std::string(text)}};
  try {
    document.root = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: this is not TOML: {}; correct the text there", name, at.line, at.column,
                                 error.description()));
  }
  for (const std::string& argument : overrides) {
    const Override change = parse_override(argument);
    texts[change.place] = change.document;
    apply(change, document.root);
  }
  note_places(document.root, nullptr, "", texts, document.source);
  return document;
}

}  // namespace strandyn::casefile
