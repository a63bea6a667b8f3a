#include "strandyn/conductor/constants.hpp"

#include <numeric>

#include "conductor/strands.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::SectionConstants;
using strandyn::conductor::Strand;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::round_layer;
using strandyn::test::steel_1x6;

TEST_CASE("constants: the 1/6 steel strand gives the published axial stiffnesses to the last printed digit") {
  // [FM2016 Table 2, Proposed Model], one more digit of the coupling from the same formulas.
  const SectionConstants c = section_constants(steel_1x6());
  check_close(c.EA, 13853e3, {.absolute = 0.5e3}, "EA [N]");
  check_close(c.EA / c.C_AT * 1e-3, 1.496, {.absolute = 0.0005}, "EA/C_AT [1/mm]");
  check_close(c.EA_free_end(), 8895e3, {.absolute = 0.5e3}, "free end [N]");
}

TEST_CASE("constants: ACSR Curlew to the last digit known") {
  const SectionConstants c = section_constants(curlew());
  check_close(c.EA, 47.1459e6, {.absolute = 0.00005e6}, "EA [N]");
  check_close(c.C_AT, -32.974e3, {.absolute = 0.0005e3}, "C_AT [N m]");
  check_close(c.GJ, 284.025, {.absolute = 0.0005}, "GJ [N m^2]");
  check_close(c.EI_min, 37.7445, {.absolute = 0.00005}, "EI_min [N m^2]");
  check_close(c.EI_max, 2387.42, {.absolute = 0.005}, "EI_max [N m^2]");
}

TEST_CASE("constants: what each layer adds by sticking sums to EI_max - EI_min, and the core adds nothing") {
  const SectionConstants c = section_constants(curlew());
  REQUIRE(c.EI_friction.size() == 5);
  CHECK(c.EI_friction[0] == 0);
  const double sum = std::accumulate(c.EI_friction.begin(), c.EI_friction.end(), 0.0);
  check_close(sum, c.EI_max - c.EI_min, {.relative = 1e-14});
}

TEST_CASE("constants: a single straight wire is a rod") {
  Strand wire;
  wire.layers = {round_layer(1, 4e-3, 0, 200e9)};
  const SectionConstants c = section_constants(wire);
  const double EA = 200e9 * std::numbers::pi * 4e-6;
  const double EI = EA * 1e-6;  // d^2/16
  check_close(c.EA, EA, {.relative = 1e-14});
  check_close(c.EI_min, EI, {.relative = 1e-14});
  check_close(c.EI_max, EI, {.relative = 1e-14});
  check_close(c.GJ, EI / 1.3, {.relative = 1e-14});
  CHECK(c.C_AT == 0);
}

TEST_CASE("constants: parallel wires bend as separate rods when they slip and as one section when they stick") {
  Strand bundle;
  bundle.layers = {round_layer(1, 4e-3, 0, 70e9), round_layer(6, 4e-3, 0, 70e9)};
  fill_helix_radii(bundle);
  const SectionConstants c = section_constants(bundle);
  const double EA = 70e9 * std::numbers::pi * 4e-6;
  check_close(c.EA, 7 * EA, {.relative = 1e-14});
  check_close(c.EI_min, 7 * EA * 1e-6, {.relative = 1e-14});
  check_close(c.EI_max - c.EI_min, 3 * EA * 16e-6, {.relative = 1e-14});  // sum of A y^2 of six wires at R = d
  CHECK(c.C_AT == 0);
}

TEST_CASE("constants: the hand of the lay changes the sign of the coupling and nothing else") {
  Strand mirrored = curlew();
  for (Layer& layer : mirrored.layers) layer.lay_angle = -layer.lay_angle;
  const SectionConstants right = section_constants(curlew());
  const SectionConstants left = section_constants(mirrored);
  CHECK(left.C_AT == -right.C_AT);
  CHECK(left.EA == right.EA);
  CHECK(left.GJ == right.GJ);
  CHECK(left.EI_min == right.EI_min);  // the printed (32), with sin a for sin^2 a, fails here
  CHECK(left.EI_max == right.EI_max);
}
