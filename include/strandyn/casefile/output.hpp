#pragma once
/// \file [output]: the moving span as a file for other programs, beside the tables of a run in time.

#include <optional>

#include "strandyn/casefile/declare.hpp"

namespace strandyn::casefile {

/// At even times, from the beginning on.
struct OutputKeys {
  std::optional<double> every;   ///< [s] this, or
  std::optional<int> per_cycle;  ///< of the cycle of the run
};

template <class V>
void keys(V& v, OutputKeys& o) {
  v.one_of({"fields_every_s", "fields_per_cycle"}, {.required = true});
  v.number("fields_every_s", o.every,
           {.help = "the time between two moments of fields.vtkhdf, which holds where the span is, how it moves, its "
                    "forces, strains, slip and losses",
            .unit = units::s,
            .above = 0});
  v.number("fields_per_cycle", o.per_cycle,
           {.help = "the number of moments of fields.vtkhdf in a cycle of the run", .at_least = 1, .at_most = 10000});
}

}  // namespace strandyn::casefile
