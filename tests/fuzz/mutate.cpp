#include "mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <limits>
#include <set>

namespace strandyn::fuzz {
namespace {

constexpr std::size_t most_words = 4096;
constexpr std::size_t most_grown = 1U << 16U;  // of an input: what is longer only takes longer

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

constexpr std::array<const char*, 22> numbers = {"0",
                                                 "-1",
                                                 "1",
                                                 "2",
                                                 "4",
                                                 "1e308",
                                                 "-1e308",
                                                 "1e-308",
                                                 "1e999",
                                                 "nan",
                                                 "inf",
                                                 "-0.0",
                                                 "1e30",
                                                 "1e-30",
                                                 "0.5",
                                                 "1e6",
                                                 "1e15",
                                                 "999999999",
                                                 "2147483648",
                                                 "9223372036854775807",
                                                 "-9223372036854775808",
                                                 "18446744073709551616"};
constexpr std::array<double, 9> raw_doubles = {0,
                                               -1,
                                               1e308,
                                               -1e308,
                                               5e-324,
                                               1e30,
                                               std::numeric_limits<double>::infinity(),
                                               -std::numeric_limits<double>::infinity(),
                                               std::numeric_limits<double>::quiet_NaN()};
constexpr std::array<std::uint64_t, 6> raw_integers = {0, 1, 255, 1U << 20U, 1ULL << 62U, ~0ULL};

/// From the place `at` on, wrapped around: where a run of letters of this kind begins, and its end.
template <class Is>
std::pair<std::size_t, std::size_t> find_run(const std::string& bytes, std::size_t at, Is is) {
  for (std::size_t tried = 0; tried < bytes.size(); ++tried, at = (at + 1) % bytes.size()) {
    if (!is(bytes[at]) || (at > 0 && is(bytes[at - 1]))) continue;
    std::size_t end = at;
    while (end < bytes.size() && is(bytes[end])) ++end;
    return {at, end};
  }
  return {0, 0};
}

}  // namespace

Mutator::Mutator(std::uint64_t seed, const std::vector<std::string>& seeds) : random_(seed), seeds_(seeds) {
  std::set<std::string> words;
  for (const std::string& text : seeds) {
    std::size_t at = 0;
    while (at < text.size() && words.size() < most_words) {
      const std::size_t begin = at;
      while (at < text.size() && is_letter(text[at])) ++at;
      if (at - begin > 2 && at - begin < 40) words.insert(text.substr(begin, at - begin));
      if (at == begin) ++at;
    }
  }
  words_.assign(words.begin(), words.end());
}

std::string Mutator::next() {
  std::string bytes = seeds_[below(seeds_.size())];
  for (std::size_t i = 0, places = 1 + below(8); i < places; ++i) change(bytes);
  return bytes;
}

void Mutator::change(std::string& bytes) {
  if (bytes.empty()) bytes.push_back('0');
  const std::size_t at = below(bytes.size());
  const std::size_t some = 1 + below(std::min<std::size_t>(64, bytes.size() - at));
  switch (below(10)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(below(256));
      break;
    case 2:
      bytes.erase(at, some);
      break;
    case 3:
      if (bytes.size() < most_grown) bytes.insert(below(bytes.size()), bytes.substr(at, some));
      break;
    case 4:
      bytes.insert(at, 1, "[]{}\"'=.,#\n\r\t\\\0 :-+"[below(19)]);
      break;
    case 5:
      bytes.resize(at);
      break;
    case 6:
      change_word(bytes);
      break;
    case 7:
      change_raw_value(bytes);
      break;
    case 8:
      splice(bytes);
      break;
    default:
      change_number(bytes);
  }
}

void Mutator::change_number(std::string& bytes) {
  const auto [from, to] = find_run(bytes, below(bytes.size()), is_digit);
  bytes.replace(from, to - from, numbers[below(numbers.size())]);
}

void Mutator::change_word(std::string& bytes) {
  if (words_.empty()) return;
  const auto [from, to] = find_run(bytes, below(bytes.size()), is_letter);
  bytes.replace(from, to - from, words_[below(words_.size())]);
}

/// Eight bytes: a number as it lies in memory.
void Mutator::change_raw_value(std::string& bytes) {
  if (bytes.size() < sizeof(double)) return;
  const std::size_t at = below(bytes.size() - sizeof(double) + 1);
  if (below(2) == 0) {
    std::memcpy(bytes.data() + at, &raw_doubles[below(raw_doubles.size())], sizeof(double));
  } else {
    std::memcpy(bytes.data() + at, &raw_integers[below(raw_integers.size())], sizeof(std::uint64_t));
  }
}

void Mutator::splice(std::string& bytes) {
  const std::string& other = seeds_[below(seeds_.size())];
  const std::size_t from = below(other.size());
  const std::size_t some = 1 + below(std::min<std::size_t>(512, other.size() - from));
  if (bytes.size() < most_grown) bytes.insert(below(bytes.size()), other.substr(from, some));
}

}  // namespace strandyn::fuzz
