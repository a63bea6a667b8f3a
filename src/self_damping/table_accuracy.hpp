#pragma once
/// \file A table of the sectional loss that is as fine as an accuracy wants it.
///
/// With L(s, p) the mean loss over a sine of curvature, by loops of s steps a half cycle at 16 of its places with p
/// points a turn, and K(s, p) the same by the table,
///     steps:   |L(s, p) - L(s/2, p)|/3       errors of order 2, which a quarter of the steps confirms
///     points:  |L(s/2, p) - L(s/2, p')|      p' the next finer, or the half where there is none
///     table:   |K(s, p) - L(s, p)|
/// each the largest of a few of the study's points at that tension. What gives the largest part is made finer until
/// their sum is below the target. No coarser table is compared: of few steps the loss is no smooth function of the
/// amplitude, and its table would never be fine enough.

#include <vector>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/self_damping/sectional_loss.hpp"

namespace strandyn::self_damping {

/// A sine at which the errors are looked for.
struct Probe {
  double curvature = 0;   ///< [1/m] its amplitude
  double least_loss = 0;  ///< [J/m] per cycle, that errors are compared with at least
};

struct TableAsk {
  const casefile::Scene& scene;
  SectionState state{};
  CurvatureRange range{};
  double target = 0;  ///< [-]
  std::vector<Probe> probes;
  Stop stop = {};
};

/// Without its tension; with its error, what was chosen, and the work of all that was tried. The knobs that the case
/// sets are kept.
LossTable table_to_target(const TableAsk& ask);

/// What it begins with, of what the case leaves open.
PointChoice first_choice_of_table(const casefile::Scene& scene, double target);

}  // namespace strandyn::self_damping
