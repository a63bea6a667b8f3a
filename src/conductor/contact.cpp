#include "strandyn/conductor/contact.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::conductor {

std::vector<ContactGeometry> contact_geometry(const Strand& strand) {
  // A straight wire has no curvature to press it on; as the limit of a helical one it needs no case of its own.
  constexpr double smallest_sine = 1e-9;

  std::vector<ContactGeometry> all;
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    const Layer& layer = strand.layers[j];
    ContactGeometry g;
    g.sin_lay = std::max(std::abs(std::sin(layer.lay_angle)), smallest_sine);
    g.cos_lay = std::cos(layer.lay_angle);
    g.kappa = j == 0 ? 0 : g.sin_lay * g.sin_lay / layer.helix_radius;
    g.c_int = 1 - g.kappa * layer.diameter / 2;
    g.c_ext = 1 + g.kappa * layer.diameter / 2;
    g.mu_int = layer.friction_inner;
    g.residual = layer.residual_force;
    if (j + 1 < strand.layers.size()) {
      g.mu_ext = strand.layers[j + 1].friction_inner;
      g.next_layer_ratio = static_cast<double>(strand.layers[j + 1].wires) / layer.wires;
    }
    all.push_back(g);
  }
  return all;
}

std::vector<ContactForces> contact_forces(const Strand& strand, const std::vector<double>& wire_force) {
  const std::vector<ContactGeometry> geometry = contact_geometry(strand);
  std::vector<ContactForces> all(geometry.size());
  double f_int_next = 0;
  for (std::size_t j = geometry.size(); j-- > 0;) {
    const ContactGeometry& g = geometry[j];
    ContactForces& f = all[j];
    f.f_ext = g.next_layer_ratio * f_int_next;
    if (j == 0) break;  // the core has nothing below it and carries no gradient
    f.f_int = std::max(0.0, (g.kappa * wire_force[j] + g.c_ext * f.f_ext) / g.c_int + g.residual);
    f.q_lim = g.mu_int * g.c_int * f.f_int + g.mu_ext * g.c_ext * f.f_ext;
    f_int_next = f.f_int;
  }
  return all;
}

std::vector<double> axial_wire_forces(const Strand& strand, double eps, double chi1) {
  std::vector<double> force;
  for (const Layer& layer : strand.layers) {
    const double c = std::cos(layer.lay_angle);
    const double s = std::sin(layer.lay_angle);
    force.push_back(layer.EA_wire() * (c * c * eps + layer.helix_radius * s * c * chi1));
  }
  return force;
}

}  // namespace strandyn::conductor
