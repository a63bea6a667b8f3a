#include <numbers>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "support/check_close.hpp"

using strandyn::section::SpatialReturnMap;
using strandyn::test::check_law;
using strandyn::test::curlew;
using strandyn::test::steel_1x6;

namespace {
constexpr double turn = 2 * std::numbers::pi;
}

TEST_CASE("battery: the spatial return map, Curlew") {
  check_law(SpatialReturnMap(curlew(), {.points = 36}),
            {.curvature = 0.1, .strain = 5e-4, .torsion = 0.02, .grid_angle = turn / 36});
}

TEST_CASE("battery: the spatial return map without residual forces, coarse and fine") {
  for (int points : {12, 72}) {
    check_law(SpatialReturnMap(curlew({.friction = 0.5, .residual_forces = false}), {.points = points}),
              {.curvature = 0.1, .strain = 5e-4, .torsion = 0.02, .grid_angle = turn / points});
  }
}

TEST_CASE("battery: the spatial return map, one layer of steel") {
  check_law(SpatialReturnMap(steel_1x6(), {.points = 36}),
            {.curvature = 0.1, .strain = 1e-3, .torsion = 0.1, .grid_angle = turn / 36});
}

TEST_CASE("battery: the spatial return map under high friction") {
  check_law(SpatialReturnMap(curlew({.friction = 2.0}), {.points = 36}),
            {.curvature = 0.3, .strain = 5e-4, .torsion = 0.02, .grid_angle = turn / 36});
}
