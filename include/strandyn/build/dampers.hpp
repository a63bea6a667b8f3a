#pragma once
/// \file The dampers of a case as `damper` knows them.

#include "strandyn/casefile/scene.hpp"
#include "strandyn/damper/hanging_damper.hpp"

namespace strandyn::build {

/// Each with the side of the clamp on which it hangs, in the order of the keys.
std::vector<damper::HangingArm> arms_of(const casefile::DamperKeys& keys);
damper::Messenger messenger_of(const casefile::DamperKeys& keys);

}  // namespace strandyn::build
