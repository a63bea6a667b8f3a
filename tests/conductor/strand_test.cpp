#include "strandyn/conductor/strand.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "conductor/strands.hpp"
#include "support/check_close.hpp"

using namespace strandyn::conductor;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::degrees;

TEST_CASE("strand: layers in radial contact stack up to the outer diameter") {
  const Strand strand = curlew();
  for (std::size_t j = 0; j < 5; ++j) {
    check_close(strand.layers[j].helix_radius, static_cast<double>(j) * 3.52e-3, {.relative = 1e-15});
  }
  check_close(strand.outer_diameter(), 9 * 3.52e-3, {.relative = 1e-15});
}

TEST_CASE("strand: a helix radius that is given stays, and the next layer lies on it") {
  Strand strand = curlew();
  strand.layers[2].helix_radius = 8e-3;
  strand.layers[3].helix_radius = 0;
  fill_helix_radii(strand);
  CHECK(strand.layers[2].helix_radius == 8e-3);
  check_close(strand.layers[3].helix_radius, 8e-3 + 3.52e-3, {.relative = 1e-15});
}

TEST_CASE("strand: the geometric mass counts the length of the helix, and is unknown where a density is missing") {
  Strand strand = curlew();
  CHECK_FALSE(strand.geometric_mass());
  for (std::size_t j = 0; j < 5; ++j) strand.layers[j].density = j < 2 ? 7780 : 2703;
  REQUIRE(strand.geometric_mass());
  check_close(*strand.geometric_mass(), 1.988, {.absolute = 0.0005}, "Curlew with the densities of EN 50182 [kg/m]");
}

TEST_CASE("strand: lay length and lay angle are one statement") {
  const double angle = lay_angle_from_length(14e-3, -0.35);
  check_close(2 * std::numbers::pi * 14e-3 / std::tan(angle), -0.35, {.relative = 1e-14});
}

TEST_CASE("strand: a trapezoidal wire that is square bends as a square") {
  check_close(trapezoid_inertia(9e-6, 3e-3), std::pow(3e-3, 4) / 12, {.relative = 1e-14});
}

TEST_CASE("strand: a sound strand has no fault, a broken one is named by layer and cause") {
  CHECK_FALSE(find_fault(curlew()));
  const auto fault_of = [](auto breaks) {
    Strand strand = curlew();
    breaks(strand);
    return find_fault(strand).value_or("no fault found");
  };
  const auto names = [](const std::string& fault, const std::string& words) {
    INFO(fault);
    CHECK(fault.find(words) != std::string::npos);
  };
  names(fault_of([](Strand& s) { s.layers.clear(); }), "no wires");
  names(fault_of([](Strand& s) { s.layers[2].wires = 0; }), "layer 2");
  names(fault_of([](Strand& s) { s.layers[2].wires = 0; }), "give at least 1");
  names(fault_of([](Strand& s) { s.layers[3].diameter = 0; }), "diameter");
  names(fault_of([](Strand& s) { s.layers[3].young = std::nan(""); }), "Young");
  names(fault_of([](Strand& s) { s.layers[3].wire_area = 0; }), "area");
  names(fault_of([](Strand& s) { s.layers[3].poisson = 0.6; }), "Poisson");
  names(fault_of([](Strand& s) { s.layers[3].residual_force = -1; }), "residual");
  names(fault_of([](Strand& s) { s.layers[3].friction_inner = -0.1; }), "friction");
  names(fault_of([](Strand& s) { s.layers[0].wires = 3; }), "core");
  names(fault_of([](Strand& s) { s.layers[3].helix_radius = 0; }), "helix radius");
  names(fault_of([](Strand& s) { s.layers[3].lay_angle = 90 * degrees; }), "lay angle");
  names(fault_of([](Strand& s) {
          s.layers[1].lay_angle = 89 * degrees;
          s.layers[1].diameter = 8e-3;
        }),
        "kappa d");
}
