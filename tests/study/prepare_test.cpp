// What a case asks and the program cannot do is refused before anything runs.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/study/analysis.hpp"

using namespace strandyn;

namespace {

/// The phrases of the `# refuses:` lines that a file begins with.
std::vector<std::string> required_phrases(const std::filesystem::path& file) {
  const std::string mark = "# refuses: ";
  std::vector<std::string> phrases;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with(mark);)
    phrases.push_back(line.substr(mark.size()));
  return phrases;
}

}  // namespace

TEST_CASE("every file of cases/refused is refused in the words that it asks for") {
  const std::filesystem::path folder = std::filesystem::path(STRANDYN_SOURCE_DIR) / "cases" / "refused";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    CAPTURE(entry.path().filename().string());
    const auto phrases = required_phrases(entry.path());
    CHECK(phrases.size() >= 2);
    std::string message = "accepted";
    try {
      const casefile::Scene scene = casefile::read_scene(entry.path());
      study::prepare(scene);
    } catch (const InputError& error) {
      message = error.what();
    }
    for (const std::string& phrase : phrases) {
      CHECK_MESSAGE(message.find(phrase) != std::string::npos, "wanted \"", phrase, "\" in: ", message);
    }
  }
  CHECK(files >= 14);
}
