#pragma once
/// \file The wind across a chain, one of two models. It acts along y, on every node with the length that the node
/// stands for.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "strandyn/air/gusts.hpp"
#include "strandyn/air/wake_oscillator.hpp"
#include "strandyn/air/wind_power.hpp"
#include "strandyn/math/time_function.hpp"

namespace strandyn::model {

/// Vortices that are locked to one mode: measured power, loop by loop (system/wind.hpp).
struct LockedInWind {
  air::Wind wind;
};

/// A wake oscillator at every node.
struct WakeWind {
  air::WakeModel wake;
  double speed = 0;                               ///< [m/s]
  math::TimeFunction history = math::Constant{};  ///< [-] times the speed
  air::Gusts gusts;                               ///< [-] times the speed
  std::vector<double> shear;                      ///< [-] per node, times the speed
  double amplitude = 2;                           ///< [-] of q at the start
  std::optional<std::uint32_t> seed;              ///< of the phases at the start, node by node; none: one phase for all
};

using Wind = std::variant<LockedInWind, WakeWind>;

}  // namespace strandyn::model
