#pragma once
/// \file Viscous damping that is made of the span itself: modal and Rayleigh damping about its state of rest.

#include "strandyn/span/rest.hpp"

namespace strandyn::span {

/// Gives the system the damping that the span was built with.
void set_proportional_damping(SpanAtRest& span);

}  // namespace strandyn::span
