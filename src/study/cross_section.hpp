#pragma once
/// \file Where the wires of a strand stand at a place along it, and their drawing.
///
/// A wire goes around the lay once in a lay length; where it begins is not known of any real strand, so the first one
/// of each layer begins at angle 0 at the left support.

#include <functional>
#include <string>
#include <vector>

#include "strandyn/conductor/strand.hpp"
#include "strandyn/section/wire_state.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

struct Wire {
  std::size_t layer = 0;  ///< counted from 1, outward from the core
  double turns = 0;       ///< where it begins at the left support, as a part of the turn
  double lay = 0;         ///< [m] the length of a turn, signed
};

/// From the core outward, layer by layer; without the core.
std::vector<Wire> wires_of(const conductor::Strand& strand);
/// Does the wire slip where it is at x [m]?
bool slips(const section::WireState& state, const Wire& wire, double x);
/// [-] of the wires around the lay, all layers together.
double slipping_share(const section::WireState& state);

/// cross_section.csv and its figure. `share` of a wire by its number in `wires_of`, from 0 to 1.
void add_cross_section(const conductor::Strand& strand, double x, const std::function<double(std::size_t)>& share,
                       const std::string& title, const std::string& caption, Outcome& outcome);

}  // namespace strandyn::study
