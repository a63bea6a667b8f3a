#include "strandyn/section/return_map.hpp"

#include <cmath>
#include <numbers>

#include "return_map_kernel.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"

namespace strandyn::section {

using enum Component;

PlanarCoefficients planar_coefficients(const conductor::Strand& strand, int points) {
  const conductor::SectionConstants constants = conductor::section_constants(strand);
  const std::vector<conductor::ContactGeometry> contact = conductor::contact_geometry(strand);
  const double dtheta = 2 * std::numbers::pi / points;
  constexpr double beyond_reach = 1e300;  // finite: zero times it is zero

  PlanarCoefficients c;
  c.EA = constants.EA;
  c.EI_min = constants.EI_min;
  c.mean_weight = 2.0 / points;
  for (int i = 0; i < points / 4; ++i) c.cosine.push_back(std::cos((i + 0.5) * dtheta));

  double f_int_per_strain = 0;  // of the layer outside
  for (std::size_t j = strand.layers.size(); j-- > 1;) {
    const conductor::Layer& wire = strand.layers[j];
    const conductor::ContactGeometry& g = contact[j];
    PlanarCoefficients::Layer layer;
    layer.k = wire.EA_wire() * g.cos_lay * g.cos_lay * g.sin_lay;
    layer.weight = wire.wires * wire.helix_radius * wire.helix_radius * g.cos_lay / g.sin_lay * c.mean_weight;
    layer.axial_weight = wire.wires * g.cos_lay / points;
    layer.half_step = wire.helix_radius * dtheta / g.sin_lay / 2;
    layer.force_per_strain = wire.EA_wire() * g.cos_lay * g.cos_lay;
    layer.force_per_twist = wire.EA_wire() * wire.helix_radius * std::sin(wire.lay_angle) * g.cos_lay;
    layer.kappa = g.kappa;
    layer.c_ext = g.c_ext;
    layer.inverse_c_int = 1 / g.c_int;
    layer.mu_int = g.mu_int;
    layer.mu_ext = g.mu_ext;
    layer.inner_residual = g.c_int * g.residual;
    layer.next_layer_ratio = g.next_layer_ratio;
    layer.slope = g.mu_int * g.kappa;
    const double b = layer.slope * layer.half_step;
    layer.outward_gain = b < 1 ? 1 / (1 - b) : 0;
    layer.outward_offset = b < 1 ? 0 : beyond_reach;
    layer.inward_gain = 1 / (1 + b);

    const double outer_per_strain = g.c_ext * g.next_layer_ratio * f_int_per_strain;
    const double inner_per_strain = g.kappa * layer.force_per_strain + outer_per_strain;
    layer.limit_per_strain = g.mu_int * inner_per_strain + g.mu_ext * outer_per_strain;
    f_int_per_strain = inner_per_strain / g.c_int;

    // The discrete mean of cos^2 over midpoints is 1/2 to rounding; summed here so that stick and march agree.
    double sum_cos2 = 0;
    for (double cosine : c.cosine) sum_cos2 += cosine * cosine;
    c.EI_friction += layer.weight * layer.k * 2 * sum_cos2;
    c.layers.push_back(layer);
  }
  return c;
}

History PlanarReturnMap::start(const Field& strains) const {
  const std::size_t block_size = return_map_kernel::rows_of_block(c_) * block_lanes;
  History history = kernel::blank_history(strains.points(), return_map_kernel::rows_of_block(c_));
  // A virgin point has an empty stick range: its first commit marches and finds the true one.
  for (std::size_t block = 0; block < history.data.size(); block += block_size) {
    double* rows = history.data.data() + block;
    for (std::size_t row : {return_map_kernel::stick_low, return_map_kernel::stick_low_slack})
      std::fill_n(rows + row * block_lanes, block_lanes, 1.0);
    for (std::size_t row : {return_map_kernel::stick_high, return_map_kernel::stick_high_slack})
      std::fill_n(rows + row * block_lanes, block_lanes, -1.0);
  }
  Field straight(Dimension::planar, strains.points());
  straight[axial] = strains[axial];
  StepEnergy ignored(strains.points());
  commit(history, straight, ignored);
  // A strand that is brought straight to a curvature slips on the way; that is part of getting there, not of a step.
  commit(history, strains, ignored);
  return history;
}

Effort PlanarReturnMap::respond(const History& history, const Field& strains, Field& stresses,
                                TangentField* tangents) const {
  return {.evaluations = strains.points(),
          .sweeps = return_map_kernel::respond(c_, history.data.data(), kernel::planar_view(strains),
                                               kernel::planar_view(stresses, tangents, c_.EA))};
}

Effort PlanarReturnMap::commit(History& history, const Field& strains, StepEnergy& energy) const {
  return {
      .evaluations = strains.points(),
      .sweeps = return_map_kernel::commit(c_, history.data.data(), kernel::planar_view(strains), kernel::view(energy))};
}

}  // namespace strandyn::section
