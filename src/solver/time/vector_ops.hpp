#pragma once
/// \file Vector arithmetic for SUNDIALS' serial vectors in the widest registers of the machine.
///
/// The library's own loops are compiled for the oldest machine of their kind; a linear step of a chain spent half of
/// its instructions in them. No operation is fused or reordered: the results are the library's, bit for bit.

#include <sundials/sundials_nvector.h>

namespace strandyn::solver {

/// Replaces the operations of a serial vector that IDA's steps spend their time in; clones inherit them.
void use_wide_operations(N_Vector v);

}  // namespace strandyn::solver
