#pragma once
/// \file What wide_blocks_kernel.cpp does, and what it leaves to a slower way.

#include "wide_blocks.hpp"

namespace strandyn::math::wide_blocks {

/// Inverts a block of B x B by Gauss and Jordan, rows exchanged where another pivot is larger; B = 5, 6.
void invert_with_exchanges(int B, const double* a, double* inverse);

}  // namespace strandyn::math::wide_blocks
