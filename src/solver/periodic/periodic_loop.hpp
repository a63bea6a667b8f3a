#pragma once
/// \file All sections of a chain led around a cycle of strains until their loops are closed.

#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::solver {

struct LoopOptions {
  int max_cycles = 10;
  double closure = 1e-9;
  Stop stop = {};  ///< asked at each sample
};

/// The closed cycle.
struct SectionLoops {
  std::vector<section::Field> stresses;  ///< per sample
  std::vector<double> friction;          ///< [J/m] per point
  std::vector<double> quadrature_error;  ///< [J/m] per point
  int cycles = 0;                        ///< that were led around
  double gap = 0;                        ///< change in the last of them, of the largest resultant of its kind
  std::size_t worst = 0;                 ///< the point where it is
  section::Effort effort = {};
};

/// From `rest` to the strains of the first sample and on. The samples follow each other in equal parts of the cycle.
SectionLoops lead_around(const section::Law& law, const section::History& rest,
                         const std::vector<section::Field>& strains, const LoopOptions& options);

}  // namespace strandyn::solver
