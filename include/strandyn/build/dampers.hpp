#pragma once
/// \file The dampers of a case as `damper` knows them.

#include "strandyn/casefile/scene.hpp"
#include "strandyn/damper/hanging_damper.hpp"

namespace strandyn::build {

/// To the left of the clamp, then to its right.
std::vector<damper::HangingArm> arms_of(const casefile::DamperKeys& keys);
damper::Messenger messenger_of(const casefile::DamperKeys& keys);

}  // namespace strandyn::build
