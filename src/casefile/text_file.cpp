#include "text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "strandyn/core/error.hpp"

namespace strandyn::casefile {

std::string read_text(const std::filesystem::path& file) {
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) {
    throw FileError(fmt::format("{}: this is a folder; give a case file", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw FileError(fmt::format("{}: cannot be read to its end", file.string()));
  return text;
}

}  // namespace strandyn::casefile
