#include "strandyn/report/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "strandyn/report/format.hpp"
#include "strandyn/results/label.hpp"

namespace strandyn::report {

using results::Value;

namespace {

std::string words_of(const Value& value, const std::string& unit) {
  if (const auto* words = value.words()) return *words;
  if (const auto flag = value.flag()) return *flag ? "yes" : "no";
  if (const auto number = value.number()) {
    return unit.empty() ? significant(*number) : fmt::format("{} {}", significant(*number), unit);
  }
  return {};
}

/// Numbers or words in a row.
bool is_row(const Value& value) {
  return std::ranges::all_of(value.entries(),
                             [](const Value& entry) { return entry.entries().empty() && entry.members().empty(); });
}

std::string row_of(const Value& value, const std::string& unit) {
  std::vector<std::string> words;
  for (const Value& entry : value.entries()) words.push_back(words_of(entry, {}));
  return fmt::format("{}{}{}", fmt::join(words, ", "), unit.empty() ? "" : " ", unit);
}

/// A row of a list of objects: its values on one line.
std::string line_of(const Value& object) {
  std::vector<std::string> words;
  for (const auto& [key, value] : object.members()) {
    const results::Label label = results::label_of(key);
    words.push_back(fmt::format("{} {}", label.name, words_of(value, label.unit)));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

void write(const Value& object, const std::string& indent, std::string& text) {
  std::size_t width = 0;
  for (const auto& [key, value] : object.members()) {
    if (!value.is_object() && (!value.is_list() || is_row(value))) {
      width = std::max(width, results::label_of(key).name.size());
    }
  }
  for (const auto& [key, value] : object.members()) {
    const results::Label label = results::label_of(key);
    if (value.is_object()) {
      text += fmt::format("{}{}\n", indent, label.name);
      write(value, indent + "  ", text);
    } else if (value.is_list() && !is_row(value)) {
      text += fmt::format("{}{}\n", indent, label.name);
      for (const Value& entry : value.entries()) text += fmt::format("{}  {}\n", indent, line_of(entry));
    } else {
      text += fmt::format("{}{:<{}}  {}\n", indent, label.name, width,
                          value.is_list() ? row_of(value, label.unit) : words_of(value, label.unit));
    }
  }
}

}  // namespace

std::string text_of(const Value& object) {
  std::string text;
  write(object, "", text);
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace strandyn::report
