#pragma once
/// \file What of a strand counts at its clamp: the wires of the outermost layer, and how many layers of aluminium there
/// are.

#include "strandyn/analysis/bending_amplitude.hpp"
#include "strandyn/casefile/scene.hpp"
#include "strandyn/fatigue/endurance.hpp"

namespace strandyn::build {

analysis::SurfaceWire surface_wire(const conductor::Strand& strand);

/// Layers whose wires are softer than steel.
fatigue::AluminiumLayers aluminium_layers(const conductor::Strand& strand);

}  // namespace strandyn::build
