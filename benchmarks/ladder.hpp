#pragma once
/// \file The tables of docs/section_ladder.md: each prints itself, as Markdown, and the strands that they share.

#include <fmt/format.h>

#include <string_view>

#include "strandyn/casefile/read.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::bench {

/// A conductor of the catalogue, friction 0.5 at every contact, residual forces as in its file.
inline conductor::Strand catalogue_strand(std::string_view name) {
  const std::string text =
      fmt::format("[conductor]\ncatalogue = \"{}\"\nfriction = 0.5\n[analysis]\ntype = \"axial-torsion\"\n", name);
  return casefile::read_scene_text(text, "the catalogue").conductor->strand;
}

/// [-] axial strain at a share `eta` of the rated strength, twist held, no bending.
inline double strain_at(const conductor::Strand& strand, double eta) {
  return eta * strand.rated_strength / conductor::section_constants(strand).EA;
}

void print_masing_tables();    ///< frozen limits against moving ones, every conductor of the catalogue
void print_points_tables();    ///< few points around the lay against many
void print_cost_tables();      ///< nanoseconds and sweeps, slipping and stuck
void print_coupling_tables();  ///< what the couplings (33) do that the symmetric form (35) leaves out

}  // namespace strandyn::bench
