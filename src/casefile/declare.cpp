#include "strandyn/casefile/declare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strandyn::casefile {

std::optional<std::string> find_fault(const Number& number, double x) {
  if (!std::isfinite(x)) return "must be a finite number";
  if (number.whole && (x != std::floor(x) || std::abs(x) > std::numeric_limits<int>::max())) {
    return "must be a whole number";
  }
  if (number.above && !(x > *number.above)) return fmt::format("must be above {}", *number.above);
  if (number.at_least && !(x >= *number.at_least)) return fmt::format("must be at least {}", *number.at_least);
  if (number.below && !(x < *number.below)) return fmt::format("must be below {}", *number.below);
  if (number.at_most && !(x <= *number.at_most)) return fmt::format("must be at most {}", *number.at_most);
  if (number.not_zero && x == 0) return "must not be 0";
  if (number.multiple_of > 0 && std::fmod(x, number.multiple_of) != 0) {
    return fmt::format("must be a multiple of {}", number.multiple_of);
  }
  return std::nullopt;
}

std::string describe(const Number& number) {
  std::string text = number.help;
  if (*number.unit.words) {
    const std::size_t end_of_noun = std::min({text.find(", "), text.find(" ("), text.size()});
    text.insert(end_of_noun, fmt::format(" in {}", number.unit.words));
  }
  if (number.word) text += fmt::format(", or \"{}\"", number.word);
  return text;
}

}  // namespace strandyn::casefile
