#pragma once
/// \file Whether what a case asks for fits into the memory there is; asked before anything of its size is made.

#include "strandyn/casefile/scene.hpp"

namespace strandyn::study {

/// Throws InputError: which key asks for too much, what that would take, and the most that fits.
void refuse_without_room(const casefile::Scene& scene);

}  // namespace strandyn::study
