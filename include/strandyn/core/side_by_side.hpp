#pragma once
/// \file Independent pieces of work on all cores.

#include <cstddef>
#include <functional>

namespace strandyn {

/// How many threads of this process can run at once: the cores that it is bound to (`taskset`, a batch system), but no
/// more than the environment's STRANDYN_CORES where that is a whole number above 0. At least 1.
std::size_t cores_at_hand();

/// Calls `body(i)` for every i below `count`, several at once and in any order; returns when all have ended. The first
/// exception ends the handing out and is thrown again. Inside a body the cores are those that the bodies beside it
/// leave: three pieces on sixteen cores may divide themselves by five each, twenty pieces by one.
void side_by_side(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace strandyn
