#include "strandyn/conductor/contact.hpp"

#include <cmath>

#include "conductor/strands.hpp"
#include "support/check_close.hpp"

using namespace strandyn::conductor;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::degrees;
using strandyn::test::steel_1x6;

TEST_CASE("contact: the wires of a single layer press on the core with their tension times their curvature") {
  const Strand strand = steel_1x6();
  const Layer& wire = strand.layers[1];
  const double kappa = std::pow(std::sin(11.8 * degrees), 2) / wire.helix_radius;
  const double c_int = 1 - kappa * wire.diameter / 2;
  const ContactForces f = contact_forces(strand, {0, 1000.0})[1];
  check_close(f.f_int, kappa * 1000 / c_int, {.relative = 1e-14});
  CHECK(f.f_ext == 0);
  check_close(f.q_lim, 0.5 * kappa * 1000, {.relative = 1e-14}, "(39) with no outer contact");
}

TEST_CASE("contact: every wire of Curlew is in radial equilibrium, and action is reaction between the layers") {
  const Strand strand = curlew();
  const std::vector<double> force = {0, 900, 300, 310, 290};
  const std::vector<ContactForces> f = contact_forces(strand, force);
  REQUIRE(f.size() == 5);
  CHECK(f[4].f_ext == 0);
  for (std::size_t j = 1; j < 5; ++j) {
    const Layer& wire = strand.layers[j];
    const double kappa = std::pow(std::sin(wire.lay_angle), 2) / wire.helix_radius;
    const double c_int = 1 - kappa * wire.diameter / 2;
    const double c_ext = 1 + kappa * wire.diameter / 2;
    check_close(c_int * f[j].f_int, kappa * force[j] + c_ext * f[j].f_ext + c_int * wire.residual_force,
                {.relative = 1e-14}, "radial equilibrium");
    check_close(wire.wires * f[j].f_int, strand.layers[j - 1].wires * f[j - 1].f_ext, {.relative = 1e-14}, "reaction");
    check_close(f[j].q_lim, 0.7 * c_int * f[j].f_int + (j == 4 ? 0 : 0.7) * c_ext * f[j].f_ext, {.relative = 1e-14},
                "Coulomb on both contact helices");
  }
}

TEST_CASE("contact: an outer layer's residual force reaches the layers below once") {
  // Nothing but the outermost layer's residual force: n f_int is handed inward unchanged but for c_ext/c_int. The
  // paper's (45b) would have it twice.
  Strand strand = curlew({.residual_forces = false});
  strand.layers[4].residual_force = 333;
  const std::vector<ContactForces> f = contact_forces(strand, {0, 0, 0, 0, 0});
  const std::vector<ContactGeometry> g = contact_geometry(strand);
  double total = 24 * 333.0;
  check_close(24 * f[4].f_int, total, {.relative = 1e-14});
  for (std::size_t j = 3; j >= 1; --j) {
    total *= g[j].c_ext / g[j].c_int;
    check_close(strand.layers[j].wires * f[j].f_int, total, {.relative = 1e-14});
  }
}

TEST_CASE("contact: friction belongs to the surface, so each layer feels its own inner and the next layer's") {
  Strand strand = curlew();
  strand.layers[3].friction_inner = 0.2;
  const std::vector<ContactGeometry> g = contact_geometry(strand);
  CHECK(g[4].mu_int == 0.7);
  CHECK(g[4].mu_ext == 0);
  CHECK(g[3].mu_int == 0.2);
  CHECK(g[3].mu_ext == 0.7);
  CHECK(g[2].mu_int == 0.7);
  CHECK(g[2].mu_ext == 0.2);
}

TEST_CASE("contact: a contact cannot pull: under compression it opens and the limit is zero") {
  const Strand strand = curlew({.residual_forces = false});
  for (const ContactForces& f : contact_forces(strand, {0, -100, -100, -100, -100})) {
    CHECK(f.f_int == 0);
    CHECK(f.q_lim == 0);
  }
}

TEST_CASE("contact: a layer whose inner contact opens is still held by the layer outside") {
  const Strand strand = curlew({.residual_forces = false});
  const std::vector<ContactForces> f = contact_forces(strand, {0, 0, 0, -1e6, 300});
  const std::vector<ContactGeometry> g = contact_geometry(strand);
  CHECK(f[3].f_int == 0);
  CHECK(f[3].f_ext > 0);
  check_close(f[3].q_lim, 0.7 * g[3].c_ext * f[3].f_ext, {.relative = 1e-14});
  CHECK(f[2].f_ext == 0);
}

TEST_CASE("contact: straight wires need residual forces to rub") {
  Strand strand = curlew({.residual_forces = false});
  for (Layer& layer : strand.layers) layer.lay_angle = 0;
  const std::vector<double> force = {300, 300, 300, 300, 300};
  // sin(alpha) is kept at 1e-9, so the curvature is below 1e-15 1/m.
  for (const ContactForces& f : contact_forces(strand, force)) check_close(f.q_lim, 0, {.absolute = 1e-11});
  strand.layers[4].residual_force = 100;
  check_close(contact_forces(strand, force)[4].q_lim, 70, {.relative = 1e-12});
}

TEST_CASE("contact: the axial forces of the wires add up to the strand's resultants (15) and (25)") {
  const Strand strand = curlew();
  const double eps = 5e-4;
  const double chi1 = 0.3;
  const std::vector<double> force = axial_wire_forces(strand, eps, chi1);
  double N = 0;
  double EA = 0;
  double C_AT = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    const Layer& wire = strand.layers[j];
    const double c = std::cos(wire.lay_angle);
    N += wire.wires * c * force[j];
    EA += wire.wires * c * c * c * wire.EA_wire();
    C_AT += wire.wires * wire.helix_radius * std::sin(wire.lay_angle) * c * c * wire.EA_wire();
  }
  check_close(N, EA * eps + C_AT * chi1, {.relative = 1e-14});
}
