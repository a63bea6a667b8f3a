#pragma once
/// \file Well-formedness of SVG and of the XML-like HTML that the page is written in.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace strandyn::test {

/// What is wrong with the tags of a text, in words; empty where every tag is closed in order and every attribute
/// quoted. Void elements of HTML need no end; a style sheet is not looked into.
inline std::string find_markup_fault(std::string_view text) {
  static constexpr std::array<std::string_view, 2> empty_elements = {"meta", "!DOCTYPE"};
  std::vector<std::string> open;
  while (true) {
    const auto start = text.find_first_of("<>");
    if (start == std::string_view::npos) break;
    if (text[start] == '>') return "a stray >";
    text.remove_prefix(start + 1);
    const auto end = text.find_first_of("<>");
    if (end == std::string_view::npos || text[end] == '<') return "a stray <";
    const std::string_view tag = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "an unbalanced quote in " + std::string(tag);
    const std::string name(tag.substr(0, tag.find_first_of(" /", 1)));
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != tag) return "an end without start: " + std::string(tag);
      open.pop_back();
    } else if (!tag.ends_with('/') &&
               std::find(empty_elements.begin(), empty_elements.end(), name) == empty_elements.end()) {
      open.push_back(name);
      if (name == "style") text.remove_prefix(std::min(text.find("</style>"), text.size()));
    }
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

inline int count_of(std::string_view text, std::string_view part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace strandyn::test
