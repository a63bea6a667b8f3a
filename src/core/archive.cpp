#include "strandyn/core/archive.hpp"

#include "strandyn/core/checksum.hpp"

namespace strandyn {
namespace {

std::string mark(const Seal& seal) {
  return "strandyn " + std::string(seal.kind) + "\n";
}

}  // namespace

std::string seal(const Seal& seal, std::string_view content) {
  Archive a;
  std::uint32_t version = seal.version;
  std::string writer(seal.writer);
  std::string body(content);
  a(version, writer, body);
  const std::string marked = mark(seal) + a.bytes();
  Archive sum;
  std::uint64_t value = checksum(marked);
  sum(value);
  return marked + sum.bytes();
}

std::string unseal(const Seal& seal, std::string_view file) {
  const std::string expected = mark(seal);
  if (!file.starts_with(expected)) throw FileError("it is no " + std::string(seal.kind) + " of strandyn");
  constexpr std::size_t sum_size = sizeof(std::uint64_t);
  if (file.size() < expected.size() + sum_size) throw FileError("it is cut off");
  const std::string_view marked = file.substr(0, file.size() - sum_size);
  Archive sum{std::string(file.substr(marked.size()))};
  std::uint64_t value = 0;
  sum(value);
  if (checksums_count && value != checksum(marked))
    throw FileError("it is damaged or cut off: its checksum does not fit");

  Archive a{std::string(marked.substr(expected.size()))};
  std::uint32_t version = 0;
  a(version);
  if (version != seal.version) {
    throw FileError("it has format " + std::to_string(version) + "; this program reads format " +
                    std::to_string(seal.version));
  }
  std::string writer, content;
  a(writer);
  if (writer != seal.writer) throw FileError("it was written by " + writer + "; this is " + std::string(seal.writer));
  a(content);
  a.finish();
  return content;
}

}  // namespace strandyn
