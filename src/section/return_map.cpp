#include "strandyn/section/return_map.hpp"

#include <cmath>
#include <numbers>

#include "return_map_kernel.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"

namespace strandyn::section {

using enum Component;

namespace {

kernel::Strains view(const Field& strains) {
  return {.points = strains.points(), .eps = strains[axial].data(), .chi = strains[bending2].data()};
}

}  // namespace

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
    layer.half_step = wire.helix_radius * dtheta / g.sin_lay / 2;
    layer.force_per_strain = wire.EA_wire() * g.cos_lay * g.cos_lay;
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
  History history{.points = strains.points(), .data = {}};
  const std::size_t blocks = padded(strains.points()) / block_lanes;
  const std::size_t block_size = kernel::rows_of_block(c_) * block_lanes;
  history.data.assign(blocks * block_size, 0.0);
  // A virgin point has an empty stick range: its first commit marches and finds the true one.
  for (std::size_t block = 0; block < blocks; ++block) {
    double* rows = history.data.data() + block * block_size;
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      rows[kernel::stick_low * block_lanes + lane] = 1;
      rows[kernel::stick_high * block_lanes + lane] = -1;
      rows[kernel::stick_low_slack * block_lanes + lane] = 1;
      rows[kernel::stick_high_slack * block_lanes + lane] = -1;
    }
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
  kernel::Response response{.N = stresses[axial].data(), .M = stresses[bending2].data()};
  if (tangents) {
    response.dM_dchi = (*tangents)(bending2, bending2).data();
    response.dM_deps = (*tangents)(bending2, axial).data();
    std::fill((*tangents)(axial, axial).begin(), (*tangents)(axial, axial).end(), c_.EA);
  }
  return {.evaluations = strains.points(), .sweeps = kernel::respond(c_, history.data.data(), view(strains), response)};
}

Effort PlanarReturnMap::commit(History& history, const Field& strains, StepEnergy& energy) const {
  const kernel::Energies energies{.stored = energy.stored.data(),
                                  .dissipated = energy.dissipated.data(),
                                  .quadrature_error = energy.quadrature_error.data()};
  return {.evaluations = strains.points(), .sweeps = kernel::commit(c_, history.data.data(), view(strains), energies)};
}

}  // namespace strandyn::section
