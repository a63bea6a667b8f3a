#pragma once
/// \file [clamps]: what the wires feel beside clamped supports, in a run that counts cycles.

#include "strandyn/casefile/declare.hpp"

namespace strandyn::casefile {

struct ClampKeys {
  double within = 0.3;      ///< [m] of the support
  double distance = 0.089;  ///< [m] at which the bending amplitude is read
  int samples_per_cycle = 50;
};

template <class V>
void keys(V& v, ClampKeys& c) {
  v.number("within_m", c.within,
           {.help = "how far from a clamped support the stresses of the wires are told", .unit = units::m, .above = 0});
  v.number("bending_amplitude_at_mm", c.distance,
           {.help = "the distance from the support at which the bending amplitude is read, 89 mm by convention",
            .unit = units::mm,
            .above = 0});
  v.number("samples_per_cycle", c.samples_per_cycle,
           {.help = "how often in a cycle the wires are looked at", .at_least = 8, .at_most = 1000});
}

}  // namespace strandyn::casefile
