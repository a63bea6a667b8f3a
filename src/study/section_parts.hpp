#pragma once
/// \file The ways to run a section: symmetric cycles, a path from a file, wires under monotonic bending.

#include "strandyn/build/section_law.hpp"
#include "strandyn/results/reference.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// Axial strain and twist of a section under tension, bending apart: the linear part is uncoupled from it.
struct AxialState {
  double strain = 0;  ///< [-]
  double twist = 0;   ///< [rad/m] 0 where twist is held
};
AxialState axial_state(const build::SectionNumbers& n, casefile::Twist twist, double tension);

/// A section twists only in the spatial law; the planar one serves, and costs less, where it does not.
section::Dimension dimension_of(const casefile::Scene& scene);

/// What the summary of each says.
std::vector<results::MemberNote> notes_of_cycles();
std::vector<results::MemberNote> notes_of_path();
std::vector<results::MemberNote> notes_of_wires();

/// Each `check` refuses what its `run` cannot do.
void check_cycles(const casefile::Scene& scene);
double expected_of_cycles(const casefile::Scene& scene);  ///< section evaluations
void run_cycles(const casefile::Scene& scene, const Hooks& hooks, Outcome& outcome);

results::Table check_path(const casefile::Scene& scene);
void run_path(const casefile::Scene& scene, const results::Table& path, const Hooks& hooks, Outcome& outcome);

void check_wires(const casefile::Scene& scene);
void list_wires(const casefile::Scene& scene, const Stop& stop, Outcome& outcome);

}  // namespace strandyn::study
