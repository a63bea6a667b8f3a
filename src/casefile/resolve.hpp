#pragma once
/// \file What needs more than one key: the strand of the conductor, and the checks between keys and tables.

#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

/// Fills conductor.strand from the layers, and the layers' derived keys from the strand, so that an echo shows them.
/// Throws InputError at the layer that no strand can have.
void resolve_conductor(Conductor& conductor, const Source& source);

/// Fills what follows from other keys (directions of loads, steps per cycle) and refuses what contradicts itself.
void resolve_scene(Scene& scene);

}  // namespace strandyn::casefile
