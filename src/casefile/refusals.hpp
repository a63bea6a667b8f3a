#pragma once
/// \file What is wrong with a case, gathered so that all of it is told at once.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

  /// Throws one InputError with a message a line, ten at most, unless nothing was refused.
  void tell() const {
    if (messages_.size() <= most_told) return pass_on();
    throw InputError(fmt::format("{}\nand {} more like these",
                                 fmt::join(messages_.begin(), messages_.begin() + most_told, "\n"),
                                 messages_.size() - most_told));
  }

  /// The same with all messages, for another one that holds it.
  void pass_on() const {
    if (!messages_.empty()) throw InputError(fmt::format("{}", fmt::join(messages_, "\n")));
  }

 private:
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
