#pragma once
/// \file Numbers as a person writes them.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace strandyn::casefile {

/// To 15 digits, so that 24.4 kN read as 24400 N comes back as 24.4; 30 and not 30.0.
inline nlohmann::ordered_json json_number(double x) {
  const double y = std::stod(fmt::format("{:.15g}", x));
  if (y == std::floor(y) && std::abs(y) < 1e15) return static_cast<std::int64_t>(y);
  return y;
}

}  // namespace strandyn::casefile
