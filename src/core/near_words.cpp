#include "strandyn/core/near_words.hpp"

#include <algorithm>

namespace strandyn {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Row i of the table of distances between the first i letters of a and the first j of b; two rows back for swaps.
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = previous;
    previous = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::vector<std::string> nearest_first(std::string_view word, std::vector<std::string> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  return candidates;
}

std::optional<std::string> near_word(std::string_view word, const std::vector<std::string>& candidates) {
  if (candidates.empty()) return std::nullopt;
  const std::string best = nearest_first(word, candidates).front();
  if (edit_distance(word, best) > std::max<std::size_t>(2, word.size() / 3)) return std::nullopt;
  return best;
}

std::string list_words(const std::vector<std::string>& words, char quote) {
  std::string list;
  for (const std::string& word : words) {
    if (!list.empty()) list += ", ";
    list += quote + word + quote;
  }
  return list;
}

}  // namespace strandyn
