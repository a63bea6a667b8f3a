#include "strandyn/casefile/declare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::casefile {

namespace {

/// Sizes whose squares and products are still numbers; nothing that can be measured lies beyond.
constexpr double smallest_size = 1e-30, largest_size = 1e30;
/// Of anything that is counted: a count times another one still fits into 64 bits.
constexpr double most_of_a_count = 1e9;

}  // namespace

std::optional<std::string> find_fault(const Number& number, double x) {
  if (!std::isfinite(x)) return "must be a finite number";
  if (number.whole && x != std::floor(x)) return "must be a whole number";
  if (number.whole && std::abs(x) > most_of_a_count) {
    return fmt::format("must be at most {:.0f}", std::min(number.at_most.value_or(most_of_a_count), most_of_a_count));
  }
  if (x != 0 && (std::abs(x) < smallest_size || std::abs(x) > largest_size)) {
    const bool may_be_zero = !number.above || *number.above < 0;
    return fmt::format("must be {}of a size between {:g} and {:g}", may_be_zero ? "0, or " : "", smallest_size,
                       largest_size);
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
