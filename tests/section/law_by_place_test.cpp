#include "strandyn/section/law_by_place.hpp"

#include <cmath>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/stiffened_law.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::test::check_close;
using strandyn::test::check_law;
using strandyn::test::curlew;
using enum Component;

namespace {

/// Strains of a wave that dies out along the chain, at one of its moments.
Field strains_at(int step, std::size_t points) {
  Field strains(Dimension::planar, points);
  for (std::size_t i = 0; i < points; ++i) {
    const double place = static_cast<double>(i) / static_cast<double>(points);
    strains[axial][i] = 5e-4 + 1e-5 * std::sin(0.2 * step);
    strains[bending2][i] = 0.05 * (1 - place) * std::sin(0.3 * step + 2 * place);
  }
  return strains;
}

Field part(const Field& whole, std::size_t first, std::size_t points) {
  Field here(Dimension::planar, points);
  for (const Component c : {axial, bending2}) {
    for (std::size_t i = 0; i < points; ++i) here[c][i] = whole[c][first + i];
  }
  return here;
}

}  // namespace

TEST_CASE("battery: a strand with armour rods") {
  check_law(StiffenedLaw(std::make_shared<PlanarReturnMap>(curlew(), 36), 350), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("armour rods: loose and bonded stiffness by hand") {
  const ArmourRods rods{.rods = 12, .diameter = 8e-3, .young = 70e9};
  const double one = 70e9 * std::acos(-1.0) * std::pow(8e-3, 4) / 64;
  check_close(rods.loose_stiffness(), 12 * one, {.relative = 1e-14});
  // Twelve rods evenly around: half of A R^2 for any axis.
  double bonded = 0;
  for (int i = 0; i < 12; ++i) {
    const double y = 19e-3 * std::cos(std::acos(-1.0) * (i + 0.3) / 6);
    bonded += one + 70e9 * std::acos(-1.0) * 16e-6 * y * y;
  }
  check_close(rods.bonded_stiffness(30e-3), bonded, {.relative = 1e-12});
}

TEST_CASE("laws by place: every stretch answers as its law alone does") {
  const std::size_t counts[] = {10, 3, 16, 9};
  const std::vector<LawByPlace::Run> runs = {
      {std::make_shared<PlanarReturnMap>(curlew(), 20), counts[0]},
      {std::make_shared<MasingLaw>(curlew()), counts[1]},
      {std::make_shared<CompliantLaw>(curlew(), CompliantOptions{.points = 12}), counts[2]},
      {std::make_shared<LinearLaw>("elastic", Dimension::planar, LinearStiffness{.EA = 4e7, .EI = 900}), counts[3]}};
  const LawByPlace law(runs);
  const std::size_t points = 38;
  History history = law.start(strains_at(0, points));
  std::vector<History> alone;
  std::size_t first = 0;
  for (const LawByPlace::Run& run : runs) {
    alone.push_back(run.law->start(part(strains_at(0, points), first, run.points)));
    first += run.points;
  }
  double lost = 0;
  for (int step = 1; step <= 60; ++step) {
    const Field strains = strains_at(step, points);
    Field stresses(Dimension::planar, points);
    TangentField tangents(Dimension::planar, points);
    StepEnergy energy(points);
    law.respond(history, strains, stresses, &tangents);
    law.commit(history, strains, energy);
    first = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::size_t count = runs[r].points;
      const Field own = part(strains, first, count);
      Field own_stresses(Dimension::planar, count);
      TangentField own_tangents(Dimension::planar, count);
      StepEnergy own_energy(count);
      runs[r].law->respond(alone[r], own, own_stresses, &own_tangents);
      runs[r].law->commit(alone[r], own, own_energy);
      for (std::size_t i = 0; i < count; ++i) {
        CAPTURE(step);
        CAPTURE(r);
        REQUIRE(stresses[axial][first + i] == own_stresses[axial][i]);
        REQUIRE(stresses[bending2][first + i] == own_stresses[bending2][i]);
        REQUIRE(tangents(bending2, axial)[first + i] == own_tangents(bending2, axial)[i]);
        REQUIRE(tangents(bending2, bending2)[first + i] == own_tangents(bending2, bending2)[i]);
        REQUIRE(energy.stored[first + i] == own_energy.stored[i]);
        REQUIRE(energy.dissipated[first + i] == own_energy.dissipated[i]);
        REQUIRE(energy.quadrature_error[first + i] == own_energy.quadrature_error[i]);
        lost += own_energy.dissipated[i];
      }
      first += count;
    }
  }
  CHECK(lost > 0);
  // The wires of a stretch are asked for by their place in the whole.
  const WireState wires = law.wires(history, strains_at(60, points), 4);
  const WireState own = runs[0].law->wires(alone[0], part(strains_at(60, points), 0, counts[0]), 4);
  CHECK(wires.layers[0].force == own.layers[0].force);
}

TEST_CASE("laws by place: what does not belong together is refused") {
  const auto planar = std::make_shared<PlanarReturnMap>(curlew(), 20);
  const auto spatial = std::make_shared<LinearLaw>("stick", Dimension::spatial, LinearStiffness{});
  CHECK_THROWS_AS(LawByPlace({}), std::invalid_argument);
  CHECK_THROWS_AS(LawByPlace({{planar, 2}, {spatial, 2}}), std::invalid_argument);
  const LawByPlace law({{planar, 2}, {planar, 3}});
  CHECK_THROWS_AS(law.start(strains_at(0, 6)), std::invalid_argument);
  // A history that is not of these stretches, as a damaged file might hold it.
  History history = law.start(strains_at(0, 5));
  Field stresses(Dimension::planar, 5);
  for (const double length : {-1.0, 3.0, 1e300}) {
    History wrong = history;
    wrong.data[0] = length;
    CHECK_THROWS_AS(law.respond(wrong, strains_at(1, 5), stresses, nullptr), strandyn::InputError);
  }
}
