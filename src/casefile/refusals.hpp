#pragma once
/// \file What is wrong with a case, gathered so that all of it is told at once.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "strandyn/core/error.hpp"

namespace strandyn::casefile {

class Refusals {
 public:
  /// Messages that are told; of those beyond it only the number.
  static constexpr std::size_t most_told = 10;

  /// Runs a check; keeps what it refuses and returns false then. Other exceptions pass.
  template <class Check>
  bool hold(Check check) {
    try {
      check();
      return true;
    } catch (const InputError& error) {
      add(error.what());
      return false;
    }
  }

  bool empty() const { return messages_.empty(); }

  /// Throws one InputError with a message a line, ten at most, in the order of the file, unless nothing was refused.
  void tell() const {
    std::vector<std::string> told = messages_;
    std::ranges::stable_sort(told, {}, line_of);
    const std::size_t beyond = told.size() - std::min(told.size(), most_told);
    told.resize(told.size() - beyond);
    if (beyond > 0) told.push_back(fmt::format("and {} more like these", beyond));
    if (!told.empty()) throw InputError(fmt::format("{}", fmt::join(told, "\n")));
  }

  /// The same with all messages, for another one that holds it.
  void pass_on() const {
    if (!messages_.empty()) throw InputError(fmt::format("{}", fmt::join(messages_, "\n")));
  }

 private:
  /// The line of a message that begins with "file:line:column: "; 0 of one that does not, as those of --set.
  static long line_of(const std::string& message) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t end = message.find(": ");
    if (end == std::string::npos || end == 0) return 0;
    const std::size_t column = message.find_last_not_of("0123456789", end - 1);
    if (column == std::string::npos || column == 0 || message[column] != ':' || !is_digit(message[end - 1])) return 0;
    const std::size_t line = message.find_last_not_of("0123456789", column - 1);
    if (line == std::string::npos || line + 1 == column || message[line] != ':') return 0;
    return std::strtol(message.c_str() + line + 1, nullptr, 10);
  }

  /// A message a line, each once.
  void add(const std::string& text) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string message = text.substr(begin, end - begin);
      if (seen_.insert(message).second) messages_.push_back(std::move(message));
      begin = end + 1;
    }
  }

  std::vector<std::string> messages_;
  std::set<std::string> seen_;
};

}  // namespace strandyn::casefile
