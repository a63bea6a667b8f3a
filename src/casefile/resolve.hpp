#pragma once
/// \file What needs more than one key: the strand of the conductor, and the checks between keys and tables.

#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

/// Fills conductor.strand from the layers, and the layers' derived keys from the strand, so that an echo shows them.
/// Throws InputError at the layer that no strand can have. `path` is where the table stands.
void resolve_conductor(Conductor& conductor, const Source& source, const std::string& path = "conductor");

/// Fills the conductors of the stretches; refuses stretches that do not fit the span, and what this version does not
/// know of a span with two conductors.
void resolve_stretches(Scene& scene);

/// Fills the directions of loads, motions and bodies; refuses places outside the span, directions that it cannot
/// follow, histories that step back.
void resolve_loads(Scene& scene);

/// Fills the dampers that the program knows by name; refuses those that do not fit the span.
void resolve_dampers(Scene& scene);

/// The checks of [air] and [material].
void check_losses(const Scene& scene);

/// The checks of [[wind]].
void check_wind(const Scene& scene);

/// Enough samples for the harmonics, in any analysis with a periodic response.
void check_periodic(const Scene& scene);

/// The checks of a sweep: its ends.
void check_sweep(const Scene& scene);

/// The velocities of a self-damping grid that names no amplitudes: those at which laboratories run.
void fill_laboratory_grid(Scene& scene);

/// The checks of a self-damping study: what a point needs, what its methods need.
void check_self_damping(const Scene& scene);

/// Refuses scenes that cannot be, though each key by itself is in order; of those that can hardly be it says so in
/// `scene.warnings`.
void check_plausible(Scene& scene);

/// Fills what follows from other keys (all of the above, steps per cycle) and refuses what contradicts itself.
void resolve_scene(Scene& scene);

}  // namespace strandyn::casefile
