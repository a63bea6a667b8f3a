#pragma once
/// \file Damping against amplitude, of a decay: decay.csv with its figure, and some of its rows in the summary.

#include "cycle_log.hpp"
#include "strandyn/analysis/steady.hpp"

namespace strandyn::study {

/// [-] of a cycle, by the ledger.
double damping_ratio_of(const observe::Cycle& cycle, const analysis::SpanNumbers& span);

/// Nothing where there are no cycles.
void add_decay(const std::vector<NumberedCycle>& cycles, const analysis::SpanNumbers& span, Outcome& outcome);
std::vector<results::MemberNote> notes_of_decay();

}  // namespace strandyn::study
