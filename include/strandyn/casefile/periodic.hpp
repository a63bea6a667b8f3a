#pragma once
/// \file How a periodic response is solved: a table of the sweep and of the self-damping study.

#include "strandyn/casefile/declare.hpp"

namespace strandyn::casefile {

/// How a periodic response is solved.
struct PeriodicKeys {
  int harmonics = 5;
  int samples = 64;  ///< per cycle
};

template <class V>
void keys(V& v, PeriodicKeys& p) {
  v.number("harmonics", p.harmonics, {.help = "the number of harmonics of the motion", .at_least = 1, .at_most = 31});
  v.number("samples", p.samples,
           {.help = "the number of samples of a cycle in which friction is followed, at least 4 harmonics + 4",
            .at_least = 8,
            .multiple_of = 2});
}

}  // namespace strandyn::casefile
