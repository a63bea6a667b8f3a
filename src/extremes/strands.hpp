#pragma once
/// \file The strands that the rows bend: Curlew of the catalogue, and what can be made of it.

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/strand.hpp"

namespace strandyn::extremes {

/// ACSR Curlew as the catalogue has it, friction 0.7.
const conductor::Strand& curlew();
/// The same with another friction coefficient, and with its residual forces multiplied.
conductor::Strand curlew_with(double friction, double residual_factor = 1);
/// A layer of 6 round wires around a core, friction 0.5, without residual forces.
conductor::Strand one_layer();
/// A core and three layers of many thin wires: EI_max/EI_min beyond 300.
conductor::Strand many_thin_wires();

/// [-] axial strain of Curlew, twist held, at a part of its rated strength.
double strain_at(double part_of_rated_strength);

/// The constants of Curlew.
const conductor::SectionConstants& curlew_constants();

}  // namespace strandyn::extremes
