#pragma once
/// \file Where along the span the energy is lost: the table of a run, and what to see in it.

#include "strandyn/observe/cycles.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// dissipation_profile.csv and its figures.
void add_profile(const observe::Profile& profile, Outcome& outcome);

}  // namespace strandyn::study
