#include "strandyn/section/compliant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "section/random_paths.hpp"
#include "strandyn/conductor/constants.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::test::check_close;
using strandyn::test::check_law;
using strandyn::test::curlew;
using strandyn::test::steel_1x6;

TEST_CASE("battery: the compliant law on Curlew") {
  check_law(CompliantLaw(curlew()), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("battery: the compliant law on Curlew without residual forces, whose contacts open") {
  check_law(CompliantLaw(curlew({.residual_forces = false})), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("battery: the compliant law on a single layer, which touches its core along lines") {
  check_law(CompliantLaw(steel_1x6()), {.curvature = 0.1, .strain = 1e-3});
}
