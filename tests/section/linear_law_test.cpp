#include "strandyn/section/linear_law.hpp"

#include "section/battery.hpp"
#include "support/check_close.hpp"

using strandyn::section::Dimension;
using strandyn::section::Field;
using strandyn::section::LinearLaw;
using strandyn::section::LinearStiffness;
using strandyn::section::StepEnergy;
using strandyn::test::check_close;
using strandyn::test::check_law;
using enum strandyn::section::Component;

namespace {
constexpr LinearStiffness curlew_like{.EA = 47e6, .GJ = 284, .C_AT = -33e3, .EI = 2387};
}

TEST_CASE("battery: the linear law, planar") {
  check_law(LinearLaw("stick", Dimension::planar, curlew_like), {.linear = true, .curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("battery: the linear law, spatial") {
  // Isotropic in every direction: 0.3 rad is as good as any.
  check_law(LinearLaw("slip", Dimension::spatial, curlew_like),
            {.linear = true, .curvature = 0.1, .strain = 5e-4, .torsion = 0.5, .grid_angle = 0.3});
}

TEST_CASE("linear law: resultants and energy by hand") {
  const LinearLaw law("elastic", Dimension::spatial, {.EA = 2, .GJ = 3, .C_AT = 0.5, .EI = 7});
  Field strains(Dimension::spatial, 1);
  strains[axial][0] = 1;
  strains[torsion][0] = 2;
  strains[bending2][0] = 3;
  strains[bending3][0] = -4;
  Field stresses(Dimension::spatial, 1);
  auto history = law.start(strains);
  const auto effort = law.respond(history, strains, stresses, nullptr);
  CHECK(stresses[axial][0] == 3);
  CHECK(stresses[torsion][0] == 6.5);
  CHECK(stresses[bending2][0] == 21);
  CHECK(stresses[bending3][0] == -28);
  CHECK(effort.evaluations == 1);
  CHECK(effort.sweeps == 0);
  StepEnergy energy(1);
  law.commit(history, strains, energy);
  check_close(energy.stored[0], (3 * 1 + 6.5 * 2 + 21 * 3 + 28 * 4) / 2.0, {.relative = 1e-15});
}
