#include "strandyn/exact/full_slip.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/exact/friction_layer.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

constexpr double rated_strength = 162.8e3;

}  // namespace

TEST_CASE("full slip: Curlew's chi_0 and M_0, with and without residual forces") {
  const auto with = test::curlew();
  const auto without = test::curlew({.residual_forces = false});
  struct Known {
    const conductor::Strand& strand;
    double eta, chi_0, M_0;
  };
  for (const Known& known : {Known{with, 0.15, 0.032618, 77.873}, Known{without, 0.15, 0.025625, 61.178},
                             Known{with, 0.40, 0.075327, 179.837}, Known{without, 0.40, 0.068334, 163.143}}) {
    const FullSlip got = full_slip(known.strand, known.eta * rated_strength);
    // The last digit given.
    check_close(got.chi_0, known.chi_0, {.absolute = 5e-7}, "chi_0");
    check_close(got.M_0, known.M_0, {.absolute = 5e-4}, "M_0");
  }
}

TEST_CASE("full slip: the midpoint rule tends to the closed form with the square of the cell") {
  const auto strand = test::curlew();
  const double exact = full_slip(strand, 0.15 * rated_strength).M_inf;
  const auto excess = [&](int points) {
    return full_slip_at_points(strand, 0.15 * rated_strength, points).M_inf / exact - 1;
  };
  check_close(excess(36), 0.0014, {.absolute = 5e-5});
  check_close(excess(72), 0.0004, {.absolute = 5e-5});
  // Next term of the error is of fourth order: 1/1600 of it at 720 points, 4 times less at 1440.
  check_close(excess(720) / excess(1440), 4, {.relative = 1e-4});
}

TEST_CASE("full slip: chi_0 is linear in the tension and all but linear in the friction") {
  const auto strand = test::curlew();
  const auto chi_0 = [](const conductor::Strand& s, double eta) { return full_slip(s, eta * rated_strength).chi_0; };
  // Exactly so in the tension, as long as no contact opens.
  check_close(chi_0(strand, 0.1) + chi_0(strand, 0.5), 2 * chi_0(strand, 0.3), {.relative = 1e-14});
  // The exponentials add second order in mu sin a; the paper sees a straight line up to 0.9. Measured: 3 %.
  check_close(chi_0(test::curlew({.friction = 0.3}), 0.15) / 0.3, chi_0(strand, 0.15) / 0.7, {.relative = 0.04});
}

TEST_CASE("full slip: a slight friction gives the layers' constant limits") {
  const double mu = 1e-5;
  const auto strand = test::curlew({.friction = mu});
  const double eps = 0.15 * rated_strength / conductor::section_constants(strand).EA;
  const auto layers = friction_layers(strand, conductor::axial_wire_forces(strand, eps, 0));
  const FullSlip slip = full_slip(strand, 0.15 * rated_strength);
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    // Mean F_b of the layers outside is of first order: m pi/12 of F_at and more from the layers around.
    check_close(slip.layer_moment[j], limit_moment(layers[j - 1]), {.relative = 2 * mu});
  }
  check_close(full_slip(test::curlew({.friction = 0}), 0.15 * rated_strength).M_inf, 0, {});
}

TEST_CASE("full slip: a contact that opens or closes on the way is the same both ways") {
  // Only the outermost layer has residual forces and the strand is compressed: there are tensions at which the inner
  // contact of layer 3 (then of layer 2) closes only where bending pulls its wires, or opens where it presses them.
  auto strand = test::curlew({.residual_forces = false});
  strand.layers[4].residual_force = 333;
  for (const double tension : {-3600.0, -3500.0, -3300.0, -3100.0, -2700.0, -2600.0}) {
    const FullSlip closed = full_slip(strand, tension);
    const FullSlip marched = full_slip_at_points(strand, tension, 40000);
    for (std::size_t j = 1; j < strand.layers.size(); ++j) {
      // (2 pi/40000)^2 = 2.5e-8, times a number below one: the rule's error, its kinks included.
      check_close(marched.layer_moment[j], closed.layer_moment[j], {.relative = 2.5e-8});
    }
    CHECK(closed.layer_moment[3] > 0);
  }
}

TEST_CASE("full slip: a strand pressed open has no friction left") {
  const FullSlip open = full_slip(test::curlew({.residual_forces = false}), -10e3);
  check_close(open.M_inf, 0, {});
  check_close(open.chi_0, 0, {});
}
