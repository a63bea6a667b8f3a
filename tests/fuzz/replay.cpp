// replay FOLDER SECONDS: the seeds of a target, the inputs of the folder that were findings once, and what a mutator of
// a fixed seed (STRANDYN_FUZZ_SEED) makes of all these in some seconds. An input that ends in any other way than with
// an answer, or takes too long, stays in the working folder as finding_<target>.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <optional>

#include "answer.hpp"
#include "mutate.hpp"
#include "target.hpp"

namespace {

using namespace strandyn::fuzz;

double seconds_so_far() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What is wrong with the way the input ended, if anything is.
std::optional<std::string> find_fault(const std::string& input) {
  const double begin = seconds_so_far();
  try {
    take(input);
  } catch (const std::exception& error) {
    return fmt::format("no answer but an exception: {}", error.what());
  }
  const double took = seconds_so_far() - begin;
  if (took > most_seconds) return fmt::format("an answer after {:.3g} s", took);
  return std::nullopt;
}

class Replay {
 public:
  explicit Replay(std::string name) : kept_("finding_" + name) {}

  /// Written first: an input that ends the program is then there.
  bool passes(const std::string& input) {
    put(kept_, input);
    ++count_;
    const double begin = seconds_so_far();
    const auto fault = find_fault(input);
    slowest_ = std::max(slowest_, seconds_so_far() - begin);
    if (fault) fmt::print("FAILED: {}; the input is in {}\n", *fault, kept_);
    return !fault;
  }
  void tell() const { fmt::print("{} inputs, the slowest took {:.3g} s\n", count_, slowest_); }
  void clean() const { std::filesystem::remove(kept_); }

 private:
  std::string kept_;
  std::size_t count_ = 0;
  double slowest_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: give a folder and seconds\n");
    return 2;
  }
  const std::vector<std::string> arguments(argv, argv + argc);
  std::vector<std::string> inputs = seeds();
  if (std::filesystem::is_directory(arguments[1])) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const auto& file : files) inputs.push_back(bytes_of(file.string()));
  }
  Replay replay{std::filesystem::path(arguments[0]).filename().string()};
  for (const std::string& input : inputs) {
    if (!replay.passes(input)) return 1;
  }
  const char* seed = std::getenv("STRANDYN_FUZZ_SEED");
  Mutator mutator(seed ? std::strtoull(seed, nullptr, 10) : 1, inputs);
  const double end = seconds_so_far() + std::strtod(arguments[2].c_str(), nullptr);
  while (seconds_so_far() < end) {
    if (!replay.passes(mutator.next())) return 1;
  }
  replay.tell();
  replay.clean();
  return 0;
}
