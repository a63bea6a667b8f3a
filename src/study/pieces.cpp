#include "strandyn/study/pieces.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "strandyn/core/error.hpp"

namespace strandyn::study {
namespace {

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::string Shard::words() const {
  return fmt::format("{}/{}", number, of);
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  std::optional<std::size_t> number, of;
  if (slash != std::string::npos) {
    number = whole_number(std::string_view(text).substr(0, slash));
    of = whole_number(std::string_view(text).substr(slash + 1));
  }
  if (!number || !of) {
    throw InputError(fmt::format("--shard {}: is no shard; give I/N, as 2/3 for the second of three", text));
  }
  if (*of == 0)
    throw InputError(fmt::format("--shard {}: there are no shards; give 1 or more behind the stroke", text));
  if (*number == 0 || *number > *of) {
    throw InputError(
        fmt::format("--shard {}: there is no such shard; {} shards have the numbers 1 to {}", text, *of, *of));
  }
  return {.number = *number, .of = *of};
}

std::vector<std::size_t> dealt(std::size_t count, const Shard& shard) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < count; ++i) {
    if ((i + i / shard.of) % shard.of + 1 == shard.number) own.push_back(i);
  }
  return own;
}

}  // namespace strandyn::study
