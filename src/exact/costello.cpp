#include "strandyn/exact/costello.hpp"

#include <cmath>
#include <stdexcept>

#include "bisect.hpp"
#include "strandyn/conductor/constants.hpp"

namespace strandyn::exact {

AxialTorsionResponse costello(const conductor::Strand& strand, const AxialTorsion& deformation,
                              Contraction contraction) {
  if (strand.layers.size() != 2) throw std::invalid_argument("Costello's closed form is for a core and one layer");
  const conductor::Layer& core = strand.layers[0];
  const conductor::Layer& layer = strand.layers[1];
  const double eps = deformation.strain;
  const double twist = deformation.twist;
  const double r = layer.helix_radius;
  const double sin_a = std::sin(layer.lay_angle);
  const double cos_a = std::cos(layer.lay_angle);
  const double thinning_core = contraction == Contraction::poisson ? core.poisson * core.diameter / (2 * r) : 0;
  const double thinning_wire = contraction == Contraction::poisson ? layer.poisson * layer.diameter / (2 * r) : 0;

  // r'/r - 1 and xi depend on each other, weakly (nu sin^2 a/2 at most): iterate until nothing moves. Strains are
  // formed without subtracting ones, so that small ones keep their digits.
  const double shear = r * twist * cos_a;  // (r/r')(1 + xi) sin a' = sin a + shear
  double xi = eps;
  double growth = 0;  // r'/r - 1
  for (int i = 0; i < 100; ++i) {
    growth = -thinning_core * eps - thinning_wire * xi;
    const double swept = sin_a * growth + shear * (1 + growth);                           // (1 + xi) sin a' - sin a
    const double square = cos_a * cos_a * eps * (2 + eps) + swept * (2 * sin_a + swept);  // (1 + xi)^2 - 1
    const double next = square / (std::sqrt(1 + square) + 1);
    if (next == xi) break;
    xi = next;
  }

  const double cos_b = (1 + eps) * cos_a / (1 + xi);  // of the deformed lay angle a'
  const double sin_b = (1 + growth) * (sin_a + shear) / (1 + xi);
  const double r_b = r * (1 + growth);
  const double G = layer.EI_wire() * (sin_b * sin_b / r_b - sin_a * sin_a / r);
  const double H = layer.EI_wire() / (1 + layer.poisson) * (sin_b * cos_b / r_b - sin_a * cos_a / r);
  const double T = layer.EA_wire() * xi;
  const double N_2 = (H * sin_b - G * cos_b) * sin_b / r_b;
  return {.deformation = deformation,
          .N = core.EA_wire() * eps + layer.wires * (T * cos_b + N_2 * sin_b),
          .M = core.EI_wire() / (1 + core.poisson) * twist +
               layer.wires * (H * cos_b + G * sin_b + r_b * (T * sin_b - N_2 * cos_b))};
}

AxialTorsionResponse costello_free_end(const conductor::Strand& strand, double strain, Contraction contraction) {
  const auto torque = [&](double twist) { return costello(strand, {.strain = strain, .twist = twist}, contraction).M; };
  if (torque(0) == 0) return costello(strand, {.strain = strain, .twist = 0}, contraction);
  // The linear theory is off by some per cent: from none to twice its twist the torque changes sign.
  const conductor::SectionConstants linear = conductor::section_constants(strand);
  const double far = -2 * linear.C_AT * strain / linear.GJ;
  const SignChange interval =
      far > 0 ? SignChange{.positive = far, .negative = 0} : SignChange{.positive = 0, .negative = far};
  return costello(strand, {.strain = strain, .twist = bisect(interval, torque)}, contraction);
}

}  // namespace strandyn::exact
