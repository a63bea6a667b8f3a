#include <algorithm>
#include <cmath>

#include "conductor/strands.hpp"
#include "section/one_spatial_point.hpp"
#include "section/plain_spatial_return_map.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "support/check_close.hpp"

using strandyn::section::Component;
using strandyn::section::Dimension;
using strandyn::section::Field;
using strandyn::section::PlanarReturnMap;
using strandyn::section::SpatialReturnMap;
using strandyn::section::StepEnergy;
using strandyn::section::WireState;
using namespace strandyn::test;

namespace {

constexpr double eps = 5e-4;

std::size_t slipping(const WireState& state) {
  std::size_t n = 0;
  for (const auto& layer : state.layers) n += static_cast<std::size_t>(std::ranges::count(layer.slips, true));
  return n;
}

}  // namespace

TEST_CASE(
    "wire state: a straight strand has equal forces around the turn, the contacts of the axial problem, no slip") {
  const auto strand = curlew();
  const SpatialReturnMap law(strand, {.points = 36});
  const double chi1 = 0.01;
  const OneSpatialPoint point(law, {.eps = eps, .chi1 = chi1});
  const WireState state = point.wires();
  const auto force = strandyn::conductor::axial_wire_forces(strand, eps, chi1);
  const auto contact = strandyn::conductor::contact_forces(strand, force);
  REQUIRE(state.layers.size() == 4);
  CHECK(slipping(state) == 0);
  for (std::size_t j = 1; j <= 4; ++j) {
    const auto& layer = state.layers[j - 1];
    check_close(layer.f_int, contact[j].f_int, {.relative = 1e-13});
    check_close(layer.f_ext, contact[j].f_ext, {.relative = 1e-13});
    for (std::size_t i = 0; i < 36; ++i) {
      check_close(layer.force[i], force[j], {.relative = 1e-13});
      check_close(layer.limit[i], contact[j].q_lim, {.relative = 1e-13});
      check_close(layer.inner_load[i], contact[j].f_int, {.relative = 1e-13});
    }
  }
}

TEST_CASE("wire state: forces of a bent strand are those of the plain implementation") {
  const auto strand = curlew();
  for (int points : {36, 72}) {
    const SpatialReturnMap law(strand, {.points = points});
    OneSpatialPoint point(law, {.eps = eps});
    PlainSpatialReturnMap plain(strand, points);
    plain.step({.eps = eps});
    PlainSpatialReturnMap::Step expected;
    SpatialStrain to{.eps = eps};
    for (int s = 1; s <= 40; ++s) {
      to = {.eps = eps, .chi1 = 1e-4 * s, .chi2 = 0.04 * std::sin(0.1 * s), .chi3 = 0.03 * std::sin(0.07 * s)};
      expected = plain.step({to.eps, to.chi1, to.chi2, to.chi3});
      point.commit(to);
    }
    const WireState state = point.wires();
    const auto axial = strandyn::conductor::axial_wire_forces(strand, to.eps, to.chi1);
    for (std::size_t j = 1; j <= 4; ++j) {
      for (std::size_t i = 0; i < state.theta.size(); ++i) {
        check_close(state.layers[j - 1].force[i], axial[j] + expected.bending_force[j][i], {.relative = 1e-11});
      }
    }
  }
}

TEST_CASE("wire state: slip begins in the layer and at the angle of the least limit and ends everywhere") {
  const SpatialReturnMap law(curlew(), {.points = 36});
  OneSpatialPoint point(law, {.eps = eps});
  std::size_t before = 0;
  for (int s = 1; s <= 30; ++s) {
    point.commit({.eps = eps, .chi3 = 0.002 * s});
    const WireState state = point.wires();
    const std::size_t now = slipping(state);
    CHECK(now >= before);
    if (before == 0 && now > 0) {
      // Bent about axis 3, the neutral plane is at theta = 90 and 270 degrees; slip starts beside it.
      for (const auto& layer : state.layers) {
        for (std::size_t i = 0; i < 36; ++i) {
          if (layer.slips[i]) CHECK(std::abs(std::sin(state.theta[i])) > 0.7);
        }
      }
    }
    before = now;
  }
  CHECK(before > 0);
  point.commit({.eps = eps, .chi3 = 1000});
  CHECK(slipping(point.wires()) == 4 * 36);
}

TEST_CASE("wire state: of the planar law and of the spatial law bent in the same plane are the same") {
  const auto strand = curlew();
  const PlanarReturnMap planar(strand, 36);
  const SpatialReturnMap spatial(strand, {.points = 36});
  Field straight(Dimension::planar, 3);
  for (std::size_t i = 0; i < 3; ++i) straight[Component::axial][i] = eps;
  auto history = planar.start(straight);
  OneSpatialPoint point(spatial, {.eps = eps});
  for (double chi : {0.03, 0.05, 0.04, -0.01, 0.02, 0.0201}) {
    Field to = straight;
    to[Component::bending2][2] = chi;
    StepEnergy ignored(3);
    planar.commit(history, to, ignored);
    point.commit({.eps = eps, .chi2 = chi});
    const WireState a = planar.wires(history, to, 2);
    const WireState b = point.wires();
    for (std::size_t j = 0; j < 4; ++j) {
      check_close(a.layers[j].f_int, b.layers[j].f_int, {.relative = 1e-12});
      for (std::size_t i = 0; i < 36; ++i) {
        check_close(a.layers[j].force[i], b.layers[j].force[i], {.relative = 1e-12});
        check_close(a.layers[j].gradient[i], b.layers[j].gradient[i], {.absolute = 1e-11 * a.layers[j].limit[i]});
        CHECK(a.layers[j].slips[i] == b.layers[j].slips[i]);
      }
    }
  }
}

TEST_CASE("wire state: where all wires stick each has the strain of a plane section and where all slip none of it") {
  const double chi = 0.03;
  for (const int points : {12, 36, 72}) {
    CAPTURE(points);
    auto strand = curlew();
    for (auto& layer : strand.layers) layer.friction_inner = 1e6;
    const SpatialReturnMap sticks(strand, {.points = points});
    OneSpatialPoint stuck(sticks, {.eps = eps});
    stuck.commit({.eps = eps, .chi2 = chi});
    const WireState state = stuck.wires();
    const auto axial = strandyn::conductor::axial_wire_forces(strand, eps, 0);
    for (std::size_t j = 1; j < strand.layers.size(); ++j) {
      const auto& layer = strand.layers[j];
      const double c = std::cos(layer.lay_angle);
      const double largest = layer.young * c * c * layer.helix_radius * chi;
      for (std::size_t i = 0; i < state.theta.size(); ++i) {
        // Axis 2 is the axis of bending: the lever of a wire at the swept angle theta is R sin(theta).
        const double stress = (state.whole_force(state.layers[j - 1], i) - axial[j]) / layer.wire_area;
        CHECK(std::abs(std::abs(stress) - largest * std::abs(std::sin(state.theta[i]))) < 1e-10 * largest);
        CHECK(std::abs(state.layers[j - 1].slip[i]) < 1e-10 * layer.helix_radius * layer.helix_radius * chi);
      }
    }
    for (auto& layer : strand.layers) layer.friction_inner = 0;
    const SpatialReturnMap slips(strand, {.points = points});
    OneSpatialPoint loose(slips, {.eps = eps});
    loose.commit({.eps = eps, .chi2 = chi});
    const WireState free = loose.wires();
    for (std::size_t j = 1; j < strand.layers.size(); ++j) {
      const auto& layer = strand.layers[j];
      const double s = std::sin(layer.lay_angle), c = std::cos(layer.lay_angle);
      for (std::size_t i = 0; i < free.theta.size(); ++i) {
        check_close(free.layers[j - 1].force[i], axial[j], {.relative = 1e-12});
        // R^2 cos^2(a)/|sin a| times the curvature that the angle sees: k e/k_w with no gradient left.
        const double slip =
            layer.helix_radius * layer.helix_radius * c * c / std::abs(s) * chi * std::cos(free.theta[i]);
        check_close(free.layers[j - 1].slip[i], slip,
                    {.absolute = 1e-10 * layer.helix_radius * layer.helix_radius * chi});
      }
    }
  }
}
