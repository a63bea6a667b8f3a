#pragma once
/// \file The two strands of the paper as plain data, typed from its tables [FM2016 Tables 1 and 3], for the tests.

#include <numbers>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::test {

constexpr double degrees = std::numbers::pi / 180;

/// Round wires of one material. Helix radii are left to radial contact.
inline conductor::Layer round_layer(int wires, double diameter, double lay_angle, double young) {
  return {.wires = wires,
          .diameter = diameter,
          .lay_angle = lay_angle,
          .young = young,
          .wire_area = conductor::round_area(diameter),
          .wire_inertia = conductor::round_inertia(diameter)};
}

/// Single-layer steel strand: Table 1 (the moduli are GPa), friction of its bending example, mu = 0.5.
inline conductor::Strand steel_1x6() {
  conductor::Strand strand;
  strand.rated_strength = 137e3;
  strand.layers = {round_layer(1, 3.94e-3, 0, 188e9), round_layer(6, 3.73e-3, 11.8 * degrees, 188e9)};
  strand.layers[1].friction_inner = 0.5;
  conductor::fill_helix_radii(strand);
  return strand;
}

struct CurlewOptions {
  double friction = 0.7;
  bool residual_forces = true;
};

/// ACSR Curlew: Table 3. Rated strength 36 600 lbf.
inline conductor::Strand curlew(CurlewOptions options = {}) {
  constexpr double d = 3.52e-3;
  constexpr double steel = 200e9;
  constexpr double aluminium = 69e9;
  constexpr double residual[] = {0, 1671, 695, 399, 333};  // [N/m]
  conductor::Strand strand;
  strand.rated_strength = 162.8e3;
  strand.layers = {round_layer(1, d, 0, steel), round_layer(6, d, 6 * degrees, steel),
                   round_layer(12, d, -10.2 * degrees, aluminium), round_layer(18, d, 11.7 * degrees, aluminium),
                   round_layer(24, d, -14.2 * degrees, aluminium)};
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    strand.layers[j].friction_inner = options.friction;
    strand.layers[j].residual_force = options.residual_forces ? residual[j] : 0;
  }
  conductor::fill_helix_radii(strand);
  return strand;
}

}  // namespace strandyn::test
