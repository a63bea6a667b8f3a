#pragma once
/// \file Which exceptions are an answer.

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "strandyn/core/error.hpp"

namespace strandyn::fuzz {

/// Runs the action; an error that the program has words for is an answer. An error without words is none.
template <class Action>
void answered(Action&& action) {
  const auto need_words = [](const std::exception& error) {
    if (std::string(error.what()).empty()) throw std::logic_error("an error without words");
  };
  try {
    action();
  } catch (const InputError& error) {
    need_words(error);
  } catch (const FileError& error) {
    need_words(error);
  } catch (const ComputationError& error) {
    need_words(error);
  }
}

/// The bytes of a file of the source tree, or of a scratch folder.
inline std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Without the `fsync` of the program's own writer: an input has no power cut to survive.
inline void put(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace strandyn::fuzz
