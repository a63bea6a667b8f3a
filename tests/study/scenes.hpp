#pragma once
/// \file Short cases for the tests of this folder.

#include <string>
#include <vector>

#include "strandyn/casefile/read.hpp"

namespace strandyn::test {

/// The conductor of the tests and a section analysis at 15 % RTS; more lines of [analysis] follow.
inline casefile::Scene section_scene(const std::string& analysis, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n"
      "[section]\nlaw = \"return-map\"\npoints = 36\n"
      "[analysis]\ntype = \"section\"\ntension_rts = 0.15\n" +
          analysis,
      STRANDYN_SOURCE_DIR "/cases/section/test.toml", overrides);
}

/// A short span; more tables follow.
inline casefile::Scene span_scene(const std::string& tables, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n"
      "[section]\nlaw = \"return-map\"\n"
      "[span]\nlength_m = 10\ntension_rts = 0.15\nelements = 40\n" +
          tables,
      "test.toml", overrides);
}

}  // namespace strandyn::test
