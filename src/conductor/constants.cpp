#include "strandyn/conductor/constants.hpp"

#include <cmath>

namespace strandyn::conductor {

SectionConstants section_constants(const Strand& strand) {
  SectionConstants sum;
  for (const Layer& layer : strand.layers) {
    const double n = layer.wires;
    const double c = std::cos(layer.lay_angle);
    const double s = std::sin(layer.lay_angle);
    const double R = layer.helix_radius;
    const double EA_w = layer.EA_wire();
    const double EI_w = layer.EI_wire();
    const double one_nu = 1 + layer.poisson;

    sum.EA += n * c * c * c * EA_w;
    sum.GJ += n * (EI_w / one_nu * (c * c * c + one_nu * s * s * c) + s * s * c * R * R * EA_w);
    sum.C_AT += n * R * s * c * c * EA_w;
    sum.EI_min += n / 2 * c * EI_w * (1 + c * c + s * s / one_nu);
    sum.EI_friction.push_back(n / 2 * c * c * c * EA_w * R * R);
  }
  sum.EI_max = sum.EI_min;
  for (double EI_c : sum.EI_friction) sum.EI_max += EI_c;
  return sum;
}

}  // namespace strandyn::conductor
