#pragma once
/// \file Which wires slip in a cycle of a vibration: by position and time, wire by wire beside the support, and in the
/// cross-section that slips most.
///
/// The last cycle is gone through once more, from the state that the run ended in: of a steady vibration that is the
/// next cycle, of a decay one that is a little too large. Nothing has to be looked at while the run goes on.

#include "strandyn/results/reference.hpp"
#include "strandyn/span/rest.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// `slip_cycle` of the summary.
struct SlipCycleRow {
  double largest_share = 0;
  double at = 0, friction = 0;
};
template <class V>
void members(V& v, SlipCycleRow& s) {
  v.value("largest_share", s.largest_share, {.what = "of all wires around the lay, that slip at once where most do"});
  v.value("at_m", s.at, {.what = "where that is, along the span"});
  v.value("friction_J", s.friction,
          {.what = "what friction takes when the last cycle is gone through once more, from the state that the run "
                   "ended in"});
}

/// slip_map.csv, wire_map.csv, cross_section.csv and their figures, where the law of the scene knows wires and some of
/// them slip. `strains` are those of the steps of the last cycle.
void add_slip_cycle(const casefile::Scene& scene, const span::SpanAtRest& span,
                    const std::vector<section::Field>& strains, Outcome& outcome);

std::vector<results::MemberNote> notes_of_slip_cycle();

}  // namespace strandyn::study
