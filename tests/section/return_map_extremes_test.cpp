// Strands and states at the ends of what a user can give: everything stays finite and finds its limit.
#include <cmath>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/return_map.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::find_fault;
using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::SectionConstants;
using strandyn::conductor::Strand;
using strandyn::section::PlanarReturnMap;
using strandyn::test::check_close;
using strandyn::test::check_law;
using strandyn::test::curlew;
using strandyn::test::degrees;
using strandyn::test::OnePoint;
using strandyn::test::PlanarStrain;
using strandyn::test::round_layer;
using strandyn::test::steel_1x6;

namespace {

Strand one_wire() {
  Strand strand;
  strand.layers = {round_layer(1, 4e-3, 0, 200e9)};
  return strand;
}

Strand straight_wires(double residual_force) {
  Strand strand = curlew({.residual_forces = false});
  for (Layer& layer : strand.layers) layer.lay_angle = 0;
  strand.layers.back().residual_force = residual_force;
  return strand;
}

/// 12 layers of 90 wires: what fits into the innermost one.
Strand heavy_rope() {
  Strand strand;
  strand.layers.push_back(round_layer(1, 60e-3, 0, 200e9));
  for (int j = 1; j <= 12; ++j) {
    Layer layer = round_layer(90, 2e-3, (j % 2 == 0 ? 15 : -15) * degrees, 200e9);
    layer.friction_inner = 0.5;
    layer.residual_force = 50;
    strand.layers.push_back(layer);
  }
  fill_helix_radii(strand);
  return strand;
}

}  // namespace

TEST_CASE("return map: from 1e-12 to 1e2 1/m, under tension, slack and compression, everything is finite") {
  for (const Strand& strand : {curlew(), curlew({.residual_forces = false}), curlew({.friction = 1000}), steel_1x6(),
                               one_wire(), heavy_rope(), straight_wires(0), straight_wires(100)}) {
    REQUIRE_FALSE(find_fault(strand));
    const PlanarReturnMap law(strand, 36);
    for (double start : {5e-4, 0.0, -5e-4}) {
      OnePoint point(law, {.eps = start, .chi = 0});
      for (double chi : {1e-12, -1e-12, 1e-6, 100.0, -100.0, 1e-12, 0.0}) {
        for (double eps : {start, 2e-3, 0.0, -2e-3}) {
          const auto answer = point.respond({.eps = eps, .chi = chi});
          CHECK(std::isfinite(answer.M));
          CHECK(std::isfinite(answer.dM_dchi));
          CHECK(std::isfinite(answer.dM_deps));
          const auto loss = point.commit({.eps = eps, .chi = chi});
          CHECK(std::isfinite(loss.stored));
          CHECK(std::isfinite(loss.dissipated));
          CHECK(std::isfinite(loss.quadrature_error));
          CHECK(loss.dissipated >= 0);
          CHECK(loss.quadrature_error >= 0);
        }
      }
    }
  }
}

TEST_CASE("return map: a curvature of 1e-12 sticks, to all digits, wherever a contact presses") {
  for (const Strand& strand : {curlew(), steel_1x6(), heavy_rope()}) {
    const PlanarReturnMap law(strand, 36);
    const OnePoint point(law, {.eps = 5e-4, .chi = 0});
    const auto answer = point.respond({.eps = 5e-4, .chi = 1e-12});
    check_close(answer.M, section_constants(strand).EI_max * 1e-12, {.relative = 1e-14});
    CHECK_FALSE(answer.swept);
  }
}

TEST_CASE("return map: at 100 1/m all slips: the tangent is EI_min") {
  // 36 points: the cell nearest to 90 degrees has cos(theta) = 0.087 and needs 0.4 1/m at most.
  for (const Strand& strand : {curlew(), steel_1x6()}) {
    const PlanarReturnMap law(strand, 36);
    const OnePoint point(law, {.eps = 5e-4, .chi = 0});
    CHECK(point.respond({.eps = 5e-4, .chi = 100}).dM_dchi == section_constants(strand).EI_min);
    CHECK(point.respond({.eps = 5e-4, .chi = -100}).dM_dchi == section_constants(strand).EI_min);
  }
}

TEST_CASE("return map: a single wire is a rod that loses nothing and is never swept") {
  const PlanarReturnMap law(one_wire(), 36);
  const double EI = section_constants(one_wire()).EI_min;
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  for (const PlanarStrain& strain : {PlanarStrain{5e-4, 0.1}, PlanarStrain{1e-4, -3}, PlanarStrain{-1e-4, 0.2}}) {
    const auto answer = point.respond(strain);
    check_close(answer.M, EI * strain.chi, {.relative = 1e-15});
    CHECK(answer.dM_dchi == EI);
    CHECK_FALSE(answer.swept);
    const auto loss = point.commit(strain);
    CHECK(loss.dissipated == 0);
    CHECK_FALSE(loss.swept);
  }
}

TEST_CASE(
    "return map: slack without residual forces nothing sticks, and with them it sticks and loses as under tension") {
  const Strand bare = curlew({.residual_forces = false});
  const SectionConstants c = section_constants(bare);
  const PlanarReturnMap slack(bare, 36);
  OnePoint loose(slack, {.eps = 0, .chi = 0});
  // The first linearization of a strand at rest: EI_min, not the EI_max of a strand that could hold.
  CHECK(loose.respond({.eps = 0, .chi = 0}).dM_dchi == c.EI_min);
  for (double chi : {1e-6, 0.1}) {
    CHECK(loose.respond({.eps = 0, .chi = chi}).M == c.EI_min * chi);
    CHECK(loose.respond({.eps = 0, .chi = chi}).dM_dchi == c.EI_min);
    CHECK(loose.commit({.eps = 0, .chi = chi}).dissipated == 0);
  }
  const PlanarReturnMap pressed(curlew(), 36);
  OnePoint held(pressed, {.eps = 0, .chi = 0});
  check_close(held.respond({.eps = 0, .chi = 1e-6}).M, c.EI_max * 1e-6, {.relative = 1e-13});
  CHECK(held.commit({.eps = 0, .chi = 0.05}).dissipated > 0);
}

TEST_CASE("return map: compression beyond the residual forces opens every contact and leaves EI_min") {
  const SectionConstants c = section_constants(curlew());
  const PlanarReturnMap law(curlew(), 36);
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  point.commit({.eps = 5e-4, .chi = 0.03});
  const auto opened = point.respond({.eps = -5e-3, .chi = 0.03});
  check_close(opened.M, c.EI_min * 0.03, {.relative = 1e-14});
  CHECK(opened.dM_dchi == c.EI_min);
  // All the energy that friction had stored is lost.
  const double stored = point.commit({.eps = 5e-4, .chi = 0.03}).stored;
  const double linear = c.EA * 5e-4 * 5e-4 / 2 + c.EI_min * 0.03 * 0.03 / 2;
  const auto loss = point.commit({.eps = -5e-3, .chi = 0.03});
  check_close(loss.dissipated - loss.quadrature_error, stored - linear, {.relative = 1e-12});
}

TEST_CASE("return map: straight wires slip unless something presses them, and then stick for good") {
  // The sine of a straight wire is kept at 1e-9: its limit is 1e-9 of a helical wire's, its reach in curvature 1e9.
  const SectionConstants c = section_constants(straight_wires(0));
  const PlanarReturnMap loose(straight_wires(0), 36);
  const OnePoint slipping(loose, {.eps = 5e-4, .chi = 0});
  check_close(slipping.respond({.eps = 5e-4, .chi = 0.1}).M, c.EI_min * 0.1, {.relative = 1e-6});
  const PlanarReturnMap pressed(straight_wires(100), 36);
  const OnePoint sticking(pressed, {.eps = 5e-4, .chi = 0});
  check_close(sticking.respond({.eps = 5e-4, .chi = 0.1}).M, c.EI_max * 0.1, {.relative = 1e-12});
}

TEST_CASE("battery: the planar return map on 12 layers of 90 wires") {
  check_law(PlanarReturnMap(heavy_rope(), 36), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("return map: a loop of 1e5 cycles does not drift") {
  const PlanarReturnMap law(curlew({}), 36);
  const double eps = 24420 / section_constants(curlew({})).EA;
  OnePoint point(law, {.eps = eps, .chi = 0});
  const auto cycle = [&] {
    double dissipated = 0;
    for (double chi : {0.03, 0.0, -0.03, 0.0}) dissipated += point.commit({.eps = eps, .chi = chi}).dissipated;
    return dissipated;
  };
  cycle();
  const double loss = cycle();
  const double moment = point.respond({.eps = eps, .chi = 0}).M;
  for (int i = 0; i < 100000; ++i) cycle();
  CHECK(loss > 0.5);
  // Every cycle meets the same limits: what differs is the rounding of a few sums, and it does not add up.
  check_close(cycle(), loss, {.relative = 1e-13});
  check_close(point.respond({.eps = eps, .chi = 0}).M, moment, {.relative = 1e-13});
}
