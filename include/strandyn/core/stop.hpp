#pragma once
/// \file Long work that is asked to end: between pieces of well under a second it asks, and ends by an exception.

#include <functional>

#include "strandyn/core/error.hpp"

namespace strandyn {

/// True: the work shall end. Empty: nobody will ask for that.
using Stop = std::function<bool()>;

/// Throws Interrupted where the work shall end.
inline void end_if_asked(const Stop& stop) {
  if (stop && stop()) throw Interrupted("stopped before there was a result");
}

}  // namespace strandyn
