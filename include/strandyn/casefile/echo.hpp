#pragma once
/// \file The case as run: every default filled in, the layers of the conductor resolved, in the case file's own keys
/// and units. Numbers are given to 15 digits.

#include "strandyn/casefile/scene.hpp"
#include "strandyn/results/value.hpp"

namespace strandyn::casefile {

results::Value case_as_run(const Scene& scene);

}  // namespace strandyn::casefile
