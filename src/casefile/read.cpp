#include "strandyn/casefile/read.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "document.hpp"
#include "reader.hpp"
#include "resolve.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::casefile {
namespace {

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

}  // namespace

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_scene_text(read_text(file), file.string(), overrides);
}

Scene read_scene_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  const Document document = parse_document(text, name, overrides);
  Scene scene;
  scene.source = document.source;
  std::vector<std::string> notes;
  Reader(document.source, document.root, "", notes).read(scene);
  scene.notes = std::move(notes);
  if (scene.title.empty()) scene.title = std::filesystem::path(name).stem().string();
  resolve_scene(scene);
  return scene;
}

}  // namespace strandyn::casefile
