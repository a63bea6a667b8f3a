#pragma once
/// \file The three ways to run a section: symmetric cycles, a path from a file, wires under monotonic bending.

#include "parts.hpp"

namespace strandyn::study {

/// Axial strain and twist of a section under tension, bending apart: the linear part is uncoupled from it.
struct AxialState {
  double strain = 0;  ///< [-]
  double twist = 0;   ///< [rad/m] 0 where twist is held
};
AxialState axial_state(const build::SectionNumbers& n, casefile::Twist twist, double tension);

/// A section twists only in the spatial law; the planar one serves, and costs less, where it does not.
section::Dimension dimension_of(const casefile::Scene& scene);

void run_section_cycles(const casefile::Scene& scene, CaseResult& result);
void run_section_path(const casefile::Scene& scene, CaseResult& result);
void list_wires(const casefile::Scene& scene, CaseResult& result);

}  // namespace strandyn::study
