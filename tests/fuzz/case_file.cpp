// A case file, up to where a run would begin to compute.
#include <filesystem>

#include "answer.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/analysis.hpp"
#include "target.hpp"

namespace strandyn::fuzz {

void take(std::string_view bytes) {
  answered([&] {
    const casefile::Scene scene = casefile::read_scene_text(bytes, "case.toml");
    results::to_text(casefile::case_as_run(scene));
    study::prepare(scene);
  });
}

/// All cases that are shipped, the refused ones among them.
std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(STRANDYN_SOURCE_DIR "/cases")) {
    if (entry.path().extension() == ".toml") texts.push_back(bytes_of(entry.path().string()));
  }
  return texts;
}

}  // namespace strandyn::fuzz
