#include "strandyn/results/folder.hpp"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cmath>

#include "results/scratch_folder.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/json.hpp"

using strandyn::FileError;
using strandyn::results::create_folder;
using strandyn::results::from_text;
using strandyn::results::read_file;
using strandyn::results::to_text;
using strandyn::results::Value;
using strandyn::results::write_file;
using strandyn::results::write_json;
using strandyn::test::message_of;
using strandyn::test::ScratchFolder;

namespace {

/// No file may grow beyond `bytes` while this lives: to a writer the same as a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_action_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    ::signal(SIGXFSZ, old_action_);
  }

 private:
  rlimit old_limit_{};
  sighandler_t old_action_;
};

}  // namespace

TEST_CASE("folder: missing parents are made, an existing folder is fine") {
  const ScratchFolder scratch;
  create_folder(scratch / "a/b/c");
  CHECK(std::filesystem::is_directory(scratch / "a/b/c"));
  CHECK_NOTHROW(create_folder(scratch / "a/b/c"));
  CHECK_NOTHROW(create_folder(scratch / "a/b/d/"));
}

TEST_CASE("folder: a file where the folder should be, or above it, is a file error with path and cause") {
  const ScratchFolder scratch;
  write_file(scratch / "file", "x");
  const auto at = (scratch / "file").string();
  CHECK(message_of<FileError>([&] { create_folder(scratch / "file"); }) ==
        "cannot create the folder " + at + ": Not a directory");
  CHECK(message_of<FileError>([&] { create_folder(scratch / "file/below"); }) ==
        "cannot create the folder " + at + "/below: Not a directory");
  CHECK(message_of<FileError>([&] { create_folder(""); }).starts_with("cannot create the folder "));
}

TEST_CASE("folder: a file is replaced whole and leaves nothing beside it") {
  const ScratchFolder scratch;
  write_file(scratch / "a.bin", "a longer first text");
  write_file(scratch / "a.bin", std::string_view("\0\n\xFF", 3));
  CHECK(read_file(scratch / "a.bin") == std::string("\0\n\xFF", 3));
  CHECK(scratch.entries() == 1);
}

TEST_CASE("folder: a file that cannot be written is a file error with path and cause") {
  const ScratchFolder scratch;
  write_file(scratch / "file", "x");
  CHECK(message_of<FileError>([&] { write_file(scratch / "file/below.txt", "y"); }) ==
        "cannot write " + (scratch / "file/below.txt").string() + ": Not a directory");
  CHECK(message_of<FileError>([&] { write_file(scratch / "none/a.txt", "y"); }) ==
        "cannot write " + (scratch / "none/a.txt").string() + ": No such file or directory");
  create_folder(scratch / "folder");
  CHECK(message_of<FileError>([&] { write_file(scratch / "folder", "y"); }) ==
        "cannot write " + (scratch / "folder").string() + ": Is a directory");
  CHECK(scratch.entries() == 2);
}

TEST_CASE("folder: when the disk is full the old file stays and the half-written one goes") {
  const ScratchFolder scratch;
  write_file(scratch / "a.txt", "old");
  std::string message;
  {
    const FullDisk full(1000);
    message = message_of<FileError>([&] { write_file(scratch / "a.txt", std::string(100000, 'n')); });
  }
  CHECK(message == "cannot write " + (scratch / "a.txt").string() + ": File too large");
  CHECK(read_file(scratch / "a.txt") == "old");
  CHECK(scratch.entries() == 1);
}

TEST_CASE("folder: json keeps the order of its keys and the bits of its numbers") {
  const ScratchFolder scratch;
  const Value value = Value::object(
      {{"title", "x"}, {"b", 0.1 + 0.2}, {"a", Value::list({1, 2.5e-300})}, {"large", 1ULL << 63}, {"none", Value()}});
  write_json(scratch / "a.json", value);
  const std::string text = read_file(scratch / "a.json");
  CHECK(text == to_text(value) + "\n");
  const Value back = from_text(text, "a.json");
  CHECK(to_text(back) == to_text(value));
  CHECK(back.members()[1].first == "b");
  CHECK(back.find("b")->number() == 0.1 + 0.2);
}

TEST_CASE("folder: json with a number that is not finite is refused with its place in the document") {
  const ScratchFolder scratch;
  const auto path = scratch / "a.json";
  const auto message = [&](const Value& value) { return message_of<FileError>([&] { write_json(path, value); }); };
  const Value summary =
      Value::object({{"title", "x"},
                     {"cycles", Value::list({Value::object({{"kinetic_J", 1.0}}),
                                             Value::object({{"t_s", 1.0}, {"kinetic_J", std::nan("")}})})}});
  CHECK(message(summary) == "refused to write " + path.string() + ": cycles[1].kinetic_J is not a finite number");
  CHECK(message(Value::object({{"a", Value::object({{"b", -HUGE_VAL}})}})) ==
        "refused to write " + path.string() + ": a.b is not a finite number");
  CHECK(message(HUGE_VAL) == "refused to write " + path.string() + ": the document is not a finite number");
  CHECK(scratch.entries() == 0);
}

TEST_CASE("folder: json with bytes that are no text is still written") {
  const ScratchFolder scratch;
  write_json(scratch / "a.json", Value::object({{"title", "bad \xFF byte"}}));
  CHECK(*from_text(read_file(scratch / "a.json"), "").find("title")->words() == "bad \xEF\xBF\xBD byte");
}
