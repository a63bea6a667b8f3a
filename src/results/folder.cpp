#include "strandyn/results/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include "strandyn/core/error.hpp"

namespace strandyn::results {
namespace {

std::string cause(int error_number) {
  return std::generic_category().message(error_number);
}

/// A file being written beside its destination; removed again unless it reaches `rename_to`.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& destination)
      : path_(destination.parent_path() / fmt::format(".{}.{}.part", destination.filename().string(), ::getpid())),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    close();
    if (!renamed_) ::unlink(path_.c_str());
  }

  bool is_open() const { return descriptor_ >= 0; }

  bool write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0;
  }

  bool rename_to(const std::filesystem::path& destination) {
    renamed_ = close() && ::rename(path_.c_str(), destination.c_str()) == 0;
    return renamed_;
  }

 private:
  bool close() {
    if (closed_) return true;
    closed_ = true;
    return ::close(descriptor_) == 0;
  }

  std::filesystem::path path_;
  int descriptor_;
  bool closed_ = false;
  bool renamed_ = false;
};

/// Where the first number stands that is not finite, as a path into the document.
std::optional<std::string> find_non_finite(const nlohmann::ordered_json& json, const std::string& place) {
  if (json.is_number_float() && !std::isfinite(json.get<double>())) return place;
  if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (auto found = find_non_finite(json[i], fmt::format("{}[{}]", place, i))) return found;
    }
  }
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      if (auto found = find_non_finite(value, place.empty() ? key : place + "." + key)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace

void create_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw FileError(fmt::format("cannot create the folder {}: {}", path.string(), error.message()));
  if (!std::filesystem::is_directory(path, error)) {
    throw FileError(fmt::format("cannot create the folder {}: {}", path.string(), cause(ENOTDIR)));
  }
  if (::access(path.c_str(), W_OK | X_OK) != 0) {
    throw FileError(fmt::format("cannot write into the folder {}: {}", path.string(), cause(errno)));
  }
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  const auto fail = [&](int error_number) {
    return FileError(fmt::format("cannot write {}: {}", path.string(), cause(error_number)));
  };
  TemporaryFile file(path);
  if (!file.is_open()) throw fail(errno);
  if (!file.write(content)) throw fail(errno);
  if (!file.rename_to(path)) throw fail(errno);
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  if (const auto place = find_non_finite(json, "")) {
    throw FileError(fmt::format("refused to write {}: {} is not a finite number", path.string(),
                                place->empty() ? "the document" : *place));
  }
  write_file(path, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::string read_file(const std::filesystem::path& path) {
  const auto fail = [&](int error_number) {
    return FileError(fmt::format("cannot read {}: {}", path.string(), cause(error_number)));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw fail(EISDIR);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw fail(errno != 0 ? errno : EIO);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw fail(EIO);
  return content;
}

}  // namespace strandyn::results
