#pragma once
/// \file The memory of IDA between two steps, which has no public way out.

#include "strandyn/core/archive.hpp"

namespace strandyn::solver {

/// Writes or reads what the next step depends on: order and step, the divided differences with their coefficients, the
/// counters. To read, `ida` must have been made for the same problem, with the same settings, and have taken a step: so
/// it has set itself up. Only where `ida_has_checkpoints()`.
void archive_ida(Archive& a, void* ida);

}  // namespace strandyn::solver
