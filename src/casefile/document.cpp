#include "document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "override.hpp"
#include "strandyn/core/error.hpp"
#include "toml_guard.hpp"

namespace strandyn::casefile {
namespace {

/// A text with the beginnings of its lines. TOML counts lines and columns from 1, columns in code points.
class Text {
 public:
  explicit Text(std::string_view text) : text_(text) {
    for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1)) {
      line_starts_.push_back(i + 1);
    }
  }

  /// The text from one place to another, on one line.
  std::string_view between(toml::source_position begin, toml::source_position end) const {
    const std::size_t from = offset_of(begin);
    return std::string_view(text_).substr(from, offset_of(end) - from);
  }

 private:
  /// Goes on from where the last question ended: a line may hold a table of a hundred thousand rows.
  std::size_t offset_of(toml::source_position place) const {
    if (place.line != last_.line || place.column < last_.column) {
      last_ = {place.line, 1};
      offset_ = line_starts_[std::min<std::size_t>(place.line, line_starts_.size()) - 1];
    }
    for (; last_.column < place.column && offset_ < text_.size(); ++last_.column) {
      ++offset_;
      while (offset_ < text_.size() && (static_cast<unsigned char>(text_[offset_]) & 0xC0) == 0x80) ++offset_;
    }
    return offset_;
  }

  std::string text_;
  std::vector<std::size_t> line_starts_ = {0};
  mutable toml::source_position last_ = {1, 1};
  mutable std::size_t offset_ = 0;
};

/// What was parsed: the file with the overrides in it, and the texts that its nodes come from by name.
struct Parsed {
  std::string name;
  toml::table root;
  std::map<std::string, Text, std::less<>> texts;
};

Parsed parse(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  if (const auto bad = find_unreadable(text)) {
    throw InputError(fmt::format("{}:{}:{}: {}; {}", name, bad->line, bad->column, bad->wrong, bad->right));
  }
  Parsed parsed{.name = name, .root = {}, .texts = {}};
  parsed.texts.emplace(name, Text(text));
  try {
    parsed.root = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: this is not TOML: {}; correct the text there", name, at.line, at.column,
                                 error.description()));
  }
  for (const std::string& argument : overrides) {
    const Override change = parse_override(argument);
    parsed.texts.insert_or_assign(change.place, Text(change.document));
    apply(change, parsed.root);
  }
  return parsed;
}

bool comes_from_override(const toml::node& node) {
  return node.source().path && is_override(*node.source().path);
}

/// The value as written, where it stands on one line.
std::string text_of(const toml::node& node, const Parsed& parsed) {
  const toml::source_region& region = node.source();
  if (node.is_table() || node.is_array_of_tables() || region.begin.line != region.end.line) return {};
  std::string value(parsed.texts.find(*region.path)->second.between(region.begin, region.end));
  while (!value.empty() && (value.back() == ' ' || value.back() == '\t')) value.pop_back();
  return value;
}

/// `key` is where the node's key stands; an element of an array has none.
Source::Entry entry_of(const toml::node& node, const toml::source_region* key, const Parsed& parsed) {
  const toml::source_region& region = node.source();
  if (comes_from_override(node)) return {.place = *region.path, .text = text_of(node, parsed), .overridden = true};
  const toml::source_position begin = key && key->begin ? key->begin : region.begin;
  return {.place = fmt::format("{}:{}:{}", parsed.name, begin.line, begin.column), .text = text_of(node, parsed)};
}

std::string path_below(const std::string& path, std::string_view key) {
  return path + (path.empty() ? "" : ".") + spell_key(key);
}

/// Notes the places below `node`. Numbers in lists are looked up when somebody asks (`find_element`), unless the
/// command line has given them: a table of a load may have a hundred thousand rows.
void note_places(const toml::node& node, const toml::source_region* key, const std::string& path, const Parsed& parsed,
                 Source& source) {
  std::string first_child;
  const auto note_child = [&](const toml::node& child, const toml::source_region* child_key, const std::string& name) {
    note_places(child, child_key, name, parsed, source);
    if (first_child.empty()) first_child = source.place(name);
  };
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, child] : *table) note_child(child, &name.source(), path_below(path, name.str()));
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      const toml::node& child = *array->get(i);
      if (child.is_table() || comes_from_override(child)) note_child(child, nullptr, fmt::format("{}[{}]", path, i));
    }
  }
  if (path.empty()) return;
  if (!node.source().path) {  // a table that an override made on its way to a key
    source.entries[path] = {.place = first_child, .text = {}, .overridden = true};
  } else {
    source.entries[path] = entry_of(node, key, parsed);
  }
}

/// The element of a list at a key path.
std::optional<Source::Entry> find_element(std::string_view wanted, const Parsed& parsed) {
  const toml::node* node = &parsed.root;
  std::string path;
  while (node && path.size() < wanted.size()) {
    const toml::node* next = nullptr;
    if (const toml::table* table = node->as_table()) {
      for (const auto& [name, child] : *table) {
        const std::string below = path_below(path, name.str());
        const bool on_the_way = wanted.starts_with(below) && wanted.substr(below.size()).find_first_of(".[") == 0;
        if (!on_the_way) continue;
        next = &child;
        path = below;
        break;
      }
    } else if (const toml::array* array = node->as_array()) {
      std::size_t i = 0;
      const char* end = wanted.data() + wanted.size();
      if (std::from_chars(wanted.data() + path.size() + 1, end, i).ec == std::errc{} && i < array->size()) {
        next = array->get(i);
        path += fmt::format("[{}]", i);
      }
    }
    node = next;
  }
  if (!node || path != wanted || !node->source().path) return std::nullopt;
  return entry_of(*node, nullptr, parsed);
}

}  // namespace

std::string spell_key(std::string_view key) {
  const bool bare = !key.empty() && key.find_first_not_of(
                                        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789_-") == std::string_view::npos;
  return bare ? std::string(key) : fmt::format("\"{}\"", key);
}

Document parse_document(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  Parsed parsed = parse(text, name, overrides);
  Document document;
  document.source.file = name;
  note_places(parsed.root, nullptr, "", parsed, document.source);
  // Only a refusal asks: it can afford to parse the text once more.
  document.source.find_element = [kept = std::string(text), name, overrides](std::string_view key_path) {
    return find_element(key_path, parse(kept, name, overrides));
  };
  document.root = std::move(parsed.root);
  return document;
}

}  // namespace strandyn::casefile
