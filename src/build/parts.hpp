#pragma once
/// \file The pieces of `build_span`: mesh, supports and what acts on the chain, the shape in which it hangs.

#include "strandyn/build/span.hpp"

namespace strandyn::build {

inline constexpr double gravity = 9.80665;  ///< [m/s^2] standard acceleration

/// Positions [m] of the nodes along the chord, or along the corners of nodes_m.
std::vector<double> mesh_positions(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built);

/// Supports, loads, motions and bodies of a chain that is laid out.
void add_supports(const casefile::Scene& scene, BuiltSpan& built);
void add_loads(const casefile::Scene& scene, BuiltSpan& built);
void add_motions(const casefile::Scene& scene, BuiltSpan& built);
void add_bodies(const casefile::Scene& scene, BuiltSpan& built);

/// The weight of a chain with all that it carries (bodies, dampers, armour rods), and the pull of a steady wind.
void add_weight(const casefile::Scene& scene, BuiltSpan& built);

/// What sets the length of a straight span without load.
struct Stringing {
  double tension = 0;                  ///< [N] horizontal component where it hangs
  double unstressed_length = 0;        ///< [m]
  std::optional<double> catenary_sag;  ///< [m] where it hangs
};
Stringing find_stringing(const casefile::Scene& scene, double EA);

/// One span of a line, or all there is.
struct Stretch {
  double from = 0, to = 0;  ///< [m] along the line
  Stringing stringing;
};
std::vector<Stretch> stretches_of(const casefile::Scene& scene, double EA);

/// [N] of the section at a place [m] along the span.
double axial_stiffness_at(const casefile::Scene& scene, const SectionNumbers& numbers, double place);
/// Sections and masses of the stretches, of a chain that is laid out and has the law of the case.
void add_stretches(const casefile::Scene& scene, model::Model& model);

/// [N/m] the pull of a steady wind across the line.
double wind_load(const casefile::Scene& scene);

/// `hanging` and `straight` of a chain under gravity.
void add_hanging_shape(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built);

}  // namespace strandyn::build
