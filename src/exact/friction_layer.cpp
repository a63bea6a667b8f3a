#include "strandyn/exact/friction_layer.hpp"

#include <cmath>
#include <numbers>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"

namespace strandyn::exact {
namespace {

constexpr double pi = std::numbers::pi;

// t - atan(t) without cancellation: the loss just above first slip.
double minus_atan(double t) {
  if (t > 0.1) return t - std::atan(t);
  double sum = 0;
  for (int k = 9; k >= 1; --k) sum = 1.0 / (2 * k + 1) - t * t * sum;
  return t * t * t * sum;
}

}  // namespace

double virgin_moment(const FrictionLayer& layer, double chi) {
  const double size = std::abs(chi);
  if (size <= layer.chi_cr) return layer.EI_c * chi;
  const double y = layer.chi_cr / size;
  // chi_cr x asin(1/x) is |chi| asin(chi_cr/|chi|)
  const double M = 2 / pi * layer.EI_c * (layer.chi_cr * std::sqrt(1 - y * y) + size * std::asin(y));
  return std::copysign(M, chi);
}

double virgin_tangent(const FrictionLayer& layer, double chi) {
  if (std::abs(chi) <= layer.chi_cr) return layer.EI_c;
  const double y = layer.chi_cr / std::abs(chi);
  return 2 / pi * layer.EI_c * (std::asin(y) - y * std::sqrt(1 - y * y));
}

double limit_moment(const FrictionLayer& layer) {
  return 4 / pi * layer.EI_c * layer.chi_cr;
}

double masing_moment(const FrictionLayer& layer, const MomentCurvature& reversal, double chi) {
  return reversal.M + 2 * virgin_moment(layer, (chi - reversal.chi) / 2);
}

double loss_per_cycle(const FrictionLayer& layer, double amplitude) {
  if (amplitude <= layer.chi_cr || layer.chi_cr == 0) return 0;
  const double x = amplitude / layer.chi_cr;
  const double t = std::sqrt((x - 1) * (x + 1));  // acos(1/x) = atan(t)
  return 16 / pi * layer.EI_c * layer.chi_cr * layer.chi_cr * minus_atan(t);
}

double loss_per_orbit(const FrictionLayer& layer, double amplitude) {
  if (amplitude <= layer.chi_cr) return 0;
  return 8 * layer.EI_c * layer.chi_cr * (amplitude - layer.chi_cr);
}

std::vector<FrictionLayer> friction_layers(const conductor::Strand& strand, const std::vector<double>& wire_force) {
  const auto geometry = conductor::contact_geometry(strand);
  const auto contact = conductor::contact_forces(strand, wire_force);
  const auto constants = conductor::section_constants(strand);
  std::vector<FrictionLayer> layers;
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    const double c = geometry[j].cos_lay;
    const double k = strand.layers[j].EA_wire() * c * c * geometry[j].sin_lay;
    layers.push_back({.EI_c = constants.EI_friction[j], .chi_cr = contact[j].q_lim / k});
  }
  return layers;
}

}  // namespace strandyn::exact
