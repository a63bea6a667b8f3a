#pragma once
/// \file The conductor of the self-damping tests; lines of [analysis] follow.

#include <string>
#include <vector>

#include "strandyn/casefile/read.hpp"

namespace strandyn::test {

inline casefile::Scene damping_scene(const std::string& law, const std::string& analysis,
                                     const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n"
      "[section]\nlaw = \"" +
          law + "\"\n[analysis]\ntype = \"self-damping\"\n" + analysis,
      "test.toml", overrides);
}

}  // namespace strandyn::test
