#include "strands.hpp"

#include <numbers>

#include "strandyn/casefile/read.hpp"

namespace strandyn::extremes {

using conductor::Layer;
using conductor::Strand;

const Strand& curlew() {
  static const Strand strand = casefile::read_scene_text(
                                   "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n"
                                   "[analysis]\ntype = \"axial-torsion\"\n",
                                   "extremes")
                                   .conductor->strand;
  return strand;
}

Strand curlew_with(double friction, double residual_factor) {
  Strand strand = curlew();
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    strand.layers[j].friction_inner = friction;
    strand.layers[j].residual_force *= residual_factor;
  }
  return strand;
}

namespace {

constexpr double degrees = std::numbers::pi / 180;

Layer wires(int count, double diameter, double lay_angle, double young) {
  return {.wires = count,
          .diameter = diameter,
          .lay_angle = lay_angle,
          .young = young,
          .friction_inner = 0.5,
          .wire_area = conductor::round_area(diameter),
          .wire_inertia = conductor::round_inertia(diameter)};
}

}  // namespace

Strand one_layer() {
  Strand strand;
  strand.layers = {wires(1, 3.94e-3, 0, 188e9), wires(6, 3.73e-3, 11.8 * degrees, 188e9)};
  fill_helix_radii(strand);
  return strand;
}

Strand many_thin_wires() {
  Strand strand;
  strand.layers = {wires(1, 12e-3, 0, 0.5e9), wires(40, 1e-3, 12 * degrees, 200e9),
                   wires(46, 1e-3, -12 * degrees, 200e9), wires(52, 1e-3, 12 * degrees, 200e9)};
  for (std::size_t j = 1; j < strand.layers.size(); ++j) strand.layers[j].residual_force = 50;
  fill_helix_radii(strand);
  return strand;
}

const conductor::SectionConstants& curlew_constants() {
  static const conductor::SectionConstants c = section_constants(curlew());
  return c;
}

double strain_at(double part_of_rated_strength) {
  return part_of_rated_strength * curlew().rated_strength / curlew_constants().EA;
}

}  // namespace strandyn::extremes
