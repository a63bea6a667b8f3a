#include "override.hpp"

#include <fmt/format.h>

#include <cctype>

#include "strandyn/core/error.hpp"
#include "toml_guard.hpp"

namespace strandyn::casefile {
namespace {

constexpr std::string_view prefix = "--set ";

[[noreturn]] void refuse_argument(const std::string& place, const std::string& wrong) {
  throw InputError(
      fmt::format("{}: {}; write KEY.PATH=VALUE, for example span.length_m=30 or load[0].amplitude_N=5", place, wrong));
}

bool is_bare(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

/// Reads the left side of an argument.
class PathReader {
 public:
  PathReader(const std::string& text, const std::string& place) : text_(text), place_(place) {}

  std::vector<Override::Step> read() {
    std::vector<Override::Step> steps;
    do {
      steps.push_back({read_key(), {}});
      while (skip('[')) steps.back().indices.push_back(read_index());
    } while (skip('.'));
    if (steps.size() > static_cast<std::size_t>(most_key_parts)) {
      refuse_argument(place_, fmt::format("a key of more than {} parts", most_key_parts));
    }
    if (!skip('=')) refuse_argument(place_, "there is no `=` after the key path");
    return steps;
  }

  /// What stands to the right of the `=`.
  std::string rest() const { return text_.substr(i_); }

 private:
  bool skip(char c) {
    if (i_ >= text_.size() || text_[i_] != c) return false;
    ++i_;
    return true;
  }

  std::string read_key() {
    std::string key;
    if (skip('"')) {
      while (i_ < text_.size() && text_[i_] != '"') key += text_[i_++];
      if (!skip('"')) refuse_argument(place_, "a quote is not closed");
    } else {
      while (i_ < text_.size() && is_bare(text_[i_])) key += text_[i_++];
    }
    if (key.empty()) refuse_argument(place_, "a key is missing");
    return key;
  }

  std::size_t read_index() {
    std::size_t index = 0;
    const std::size_t begin = i_;
    while (i_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[i_])) && i_ < begin + 6) {
      index = 10 * index + static_cast<std::size_t>(text_[i_++] - '0');
    }
    if (i_ == begin || !skip(']')) refuse_argument(place_, "an index must be a whole number in [ ], counted from 0");
    return index;
  }

  const std::string& text_;
  const std::string& place_;
  std::size_t i_ = 0;
};

bool parses(const std::string& document) {
  if (find_unreadable(document)) return false;
  try {
    return toml::parse(document).size() == 1;
  } catch (const toml::parse_error&) {
    return false;
  }
}

/// The element `index` of a node that must be an array holding it.
toml::node& element(toml::node& node, std::size_t index, const Override& change, const std::string& key) {
  toml::array* array = node.as_array();
  if (!array) refuse_argument(change.place, fmt::format("`{}` is no list", key));
  if (index >= array->size()) {
    refuse_argument(change.place, fmt::format("`{}` has {} elements in the file, counted from 0", key, array->size()));
  }
  return *array->get(index);
}

}  // namespace

bool is_override(std::string_view place) {
  return place.starts_with(prefix);
}

Override parse_override(const std::string& argument) {
  Override change;
  change.place = std::string(prefix) + argument;
  PathReader reader(argument, change.place);
  change.steps = reader.read();
  const std::string value = reader.rest();
  if (value.find_first_of("\r\n") != std::string::npos) refuse_argument(change.place, "a value stands on one line");
  change.document = "value = " + value;
  if (parses(change.document)) return change;

  const bool word = !value.empty() && (std::isalpha(static_cast<unsigned char>(value[0])) || value[0] == '/' ||
                                       value[0] == '.' || value[0] == '_');
  change.document = fmt::format("value = \"{}\"", value);
  if (!word || !parses(change.document)) refuse_argument(change.place, "the value is neither TOML nor a bare word");
  return change;
}

void apply(const Override& change, toml::table& root) {
  toml::table parsed = toml::parse(change.document, change.place);
  toml::node& value = *parsed.get("value");
  toml::table* table = &root;
  for (std::size_t i = 0; i + 1 < change.steps.size(); ++i) {
    const auto& [key, indices] = change.steps[i];
    if (!table->get(key) && indices.empty()) table->insert(key, toml::table{});
    toml::node* node = table->get(key);
    if (!node) refuse_argument(change.place, fmt::format("the file has no `{}`", key));
    for (const std::size_t index : indices) node = &element(*node, index, change, key);
    table = node->as_table();
    if (!table) refuse_argument(change.place, fmt::format("`{}` is no table", key));
  }

  const auto& [key, indices] = change.steps.back();
  if (indices.empty()) {
    value.visit([&, &name = key](auto& v) { table->insert_or_assign(name, std::move(v)); });
    return;
  }
  toml::node* list = table->get(key);
  if (!list) refuse_argument(change.place, fmt::format("the file has no `{}`", key));
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) list = &element(*list, indices[i], change, key);
  element(*list, indices.back(), change, key);
  toml::array& array = *list->as_array();
  value.visit([&, at = indices.back()](auto& v) {
    array.replace(array.cbegin() + static_cast<std::ptrdiff_t>(at), std::move(v));
  });
}

}  // namespace strandyn::casefile
