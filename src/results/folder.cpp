#include "strandyn/results/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>
#include <vector>

#include "strandyn/core/error.hpp"
#include "strandyn/results/writing.hpp"

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

/// What a program that was killed has left half written; a program that still runs goes on with its own.
void take_away_parts(const std::filesystem::path& folder) {
  constexpr std::string_view ending = ".part";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') || !name.ends_with(ending)) continue;
    const std::string rest = name.substr(0, name.size() - ending.size());
    const std::size_t dot = rest.rfind('.');
    pid_t writer = 0;
    const char* end = rest.data() + rest.size();
    const auto [stop, fault] = std::from_chars(rest.data() + dot + 1, end, writer);
    if (fault != std::errc{} || stop != end || writer <= 0) continue;
    if (writer != ::getpid() && ::kill(writer, 0) != 0 && errno == ESRCH) std::filesystem::remove(entry.path(), error);
  }
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
  take_away_parts(path);
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  const auto fail = [&](int error_number) {
    return FileError(fmt::format("cannot write {}: {}", path.string(), cause(error_number)));
  };
  const Writing writing;
  Writing::count(content.size());
  TemporaryFile file(path);
  if (!file.is_open()) throw fail(errno);
  if (!file.write(content)) throw fail(errno);
  if (!file.rename_to(path)) throw fail(errno);
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
  // A device may have no end, and no file of a case or a run comes near this.
  constexpr std::size_t most = std::size_t{1} << 30U;
  std::string content;
  std::vector<char> piece(std::size_t{1} << 16U);
  do {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    if (content.size() > most) throw fail(EFBIG);
  } while (stream);
  if (stream.bad()) throw fail(EIO);
  return content;
}

}  // namespace strandyn::results
