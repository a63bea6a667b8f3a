#pragma once
/// \file The case as run: every default filled in, the layers of the conductor resolved, in the case file's own keys
/// and units. Numbers are given to 15 digits.

#include <nlohmann/json.hpp>

#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

nlohmann::ordered_json case_as_run(const Scene& scene);

}  // namespace strandyn::casefile
