#include "strandyn/section/spatial_return_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "spatial_return_map_kernel.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"

namespace strandyn::section {

using enum Component;

SpatialCoefficients spatial_coefficients(const conductor::Strand& strand, const SpatialReturnMapOptions& options) {
  const conductor::SectionConstants constants = conductor::section_constants(strand);
  const std::vector<conductor::ContactGeometry> contact = conductor::contact_geometry(strand);
  const PlanarCoefficients planar = planar_coefficients(strand, options.points);

  SpatialCoefficients c;
  c.points = options.points;
  c.dtheta = 2 * std::numbers::pi / options.points;
  c.EA = constants.EA;
  c.GJ = constants.GJ;
  c.C_AT = constants.C_AT;
  c.EI_min = constants.EI_min;
  c.EI_friction = planar.EI_friction;
  c.axial_resultants = options.axial_resultants;
  c.cosine = planar.cosine;
  for (int i = 0; i < options.points / 4; ++i) c.sine.push_back(std::sin((i + 0.5) * c.dtheta));

  double f_int_per_twist = 0;  // the most that a unit of twist can change the load of the layer outside
  for (std::size_t i = 0; i < planar.layers.size(); ++i) {
    const std::size_t j = strand.layers.size() - 1 - i;
    const conductor::Layer& wire = strand.layers[j];
    const double sine = std::sin(wire.lay_angle);
    SpatialCoefficients::Layer layer{planar.layers[i]};
    layer.weight /= 2;
    layer.stick_force = layer.half_step * layer.k / std::tan(c.dtheta / 2);
    layer.torsion_weight = wire.wires * wire.helix_radius * sine / options.points;

    const double outer = layer.c_ext * layer.next_layer_ratio * f_int_per_twist;
    const double inner = layer.kappa * std::abs(layer.force_per_twist) + outer;
    if (layer.limit_per_strain > 0) {
      c.twist_drop = std::max(c.twist_drop, (layer.mu_int * inner + layer.mu_ext * outer) / layer.limit_per_strain);
    }
    f_int_per_twist = inner * layer.inverse_c_int;
    c.layers.push_back(layer);
  }
  return c;
}

History SpatialReturnMap::start(const Field& strains) const {
  const std::size_t block_size = spatial_kernel::rows_of_block(c_) * block_lanes;
  History history = kernel::blank_history(strains.points(), spatial_kernel::rows_of_block(c_));
  // A virgin point has no kite: its first commit marches and finds one.
  for (std::size_t block = 0; block < history.data.size(); block += block_size) {
    double* rows = history.data.data() + block;
    std::fill_n(rows + spatial_kernel::stick_middle * block_lanes, block_lanes, spatial_kernel::no_kite);
    std::fill_n(rows + spatial_kernel::inverse_length * block_lanes, block_lanes, spatial_kernel::without_bound);
  }
  Field straight(Dimension::spatial, strains.points());
  straight[axial] = strains[axial];
  straight[torsion] = strains[torsion];
  StepEnergy ignored(strains.points());
  commit(history, straight, ignored);
  // A strand that is brought straight to a curvature slips on the way; that is part of getting there, not of a step.
  commit(history, strains, ignored);
  return history;
}

Effort SpatialReturnMap::respond(const History& history, const Field& strains, Field& stresses,
                                 TangentField* tangents) const {
  return {.evaluations = strains.points(),
          .sweeps = spatial_kernel::respond(c_, history.data.data(), kernel::spatial_view(strains),
                                            kernel::spatial_view(stresses, tangents))};
}

Effort SpatialReturnMap::commit(History& history, const Field& strains, StepEnergy& energy) const {
  return {
      .evaluations = strains.points(),
      .sweeps = spatial_kernel::commit(c_, history.data.data(), kernel::spatial_view(strains), kernel::view(energy))};
}

}  // namespace strandyn::section
