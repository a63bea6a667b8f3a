#pragma once
/// \file Numbers as a person writes them.

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace strandyn::casefile {

/// To 15 digits, so that 24.4 kN read as 24400 N comes back as 24.4.
inline double plain_number(double x) {
  return std::stod(fmt::format("{:.15g}", x));
}

/// Written as 30 and not as 30.0.
inline bool is_whole(double x) {
  return x == std::floor(x) && std::abs(x) < 1e15;
}

}  // namespace strandyn::casefile
