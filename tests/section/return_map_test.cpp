#include "strandyn/section/return_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "strandyn/conductor/constants.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::SectionConstants;
using strandyn::conductor::Strand;
using strandyn::section::Dimension;
using strandyn::section::Effort;
using strandyn::section::Field;
using strandyn::section::History;
using strandyn::section::PlanarReturnMap;
using strandyn::section::StepEnergy;
using strandyn::section::TangentField;
using strandyn::test::check_close;
using strandyn::test::check_law;
using strandyn::test::curlew;
using strandyn::test::CurlewOptions;
using strandyn::test::degrees;
using strandyn::test::OnePoint;
using strandyn::test::round_layer;
using strandyn::test::steel_1x6;
using enum strandyn::section::Component;

namespace {

/// Axial strain of Curlew at a part of its rated strength, twist held.
double strain_at(double eta) {
  return eta * 162.8e3 / section_constants(curlew()).EA;
}

struct Knee {
  double chi_0 = 0;  ///< [1/m]
  double M_0 = 0;    ///< [N m]
};

/// Where the line of full stick meets the line of full slip. At 1000 1/m even the cell next to 90 degrees slips.
Knee knee_of(const Strand& strand, double eta, int points) {
  const SectionConstants c = section_constants(strand);
  const PlanarReturnMap law(strand, points);
  const double eps = strain_at(eta);
  const OnePoint point(law, {.eps = eps, .chi = 0});
  const double M_inf = point.respond({.eps = eps, .chi = 1000}).M - c.EI_min * 1000;
  const double chi_0 = M_inf / (c.EI_max - c.EI_min);
  return {.chi_0 = chi_0, .M_0 = c.EI_max * chi_0};
}

/// Loss of the second symmetric cycle. [J/m]
double loop_area(const Strand& strand, double eta, double amplitude) {
  const PlanarReturnMap law(strand, 36);
  const double eps = strain_at(eta);
  OnePoint point(law, {.eps = eps, .chi = 0});
  double area = 0;
  for (int s = 1; s <= 400; ++s) {
    const auto loss = point.commit({.eps = eps, .chi = amplitude * std::sin(2 * std::numbers::pi * s / 200)});
    if (s > 200) area += loss.dissipated;
  }
  return area;
}

/// One layer that slides on nothing but sits under straight wires whose residual force holds it: its limit is the same
/// at every angle and for every tension. The straight wires stick.
struct ConstantLimit {
  Strand strand;
  double q_lim = 0;  ///< [N/m]
  double k = 0;      ///< [N m]
  double C = 0;      ///< [m^2]

  ConstantLimit() {
    constexpr double d = 3e-3;
    constexpr double angle = 12 * degrees;
    strand.layers = {round_layer(1, d, 0, 70e9), round_layer(6, d, angle, 70e9), round_layer(12, d, 0, 70e9)};
    fill_helix_radii(strand);
    strand.layers[2].friction_inner = 0.5;
    strand.layers[2].residual_force = 400;
    const Layer& wire = strand.layers[1];
    const double kappa = std::pow(std::sin(angle), 2) / wire.helix_radius;
    q_lim = 0.5 * (1 + kappa * d / 2) * 2 * 400;  // two straight wires on each wire of the layer
    k = wire.EA_wire() * std::pow(std::cos(angle), 2) * std::sin(angle);
    C = 6 * std::pow(wire.helix_radius, 2) / std::tan(angle);
  }
  double first_slip() const { return q_lim / k; }
};

}  // namespace

TEST_CASE("battery: the planar return map on Curlew") {
  check_law(PlanarReturnMap(curlew(), 36), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("battery: the planar return map without residual forces, where contacts open and close") {
  check_law(PlanarReturnMap(curlew({.residual_forces = false}), 72), {.curvature = 0.1, .strain = 5e-4});
}

TEST_CASE("battery: the planar return map on a single layer, with the fewest points") {
  check_law(PlanarReturnMap(steel_1x6(), 4), {.curvature = 0.05, .strain = 1e-3});
}

TEST_CASE("return map: curvature and moment of full slip of Curlew are the published ones") {
  struct Published {
    double eta;
    bool residual_forces;
    Knee knee;
  };
  for (const Published& p : {Published{0.15, true, {0.032618, 77.873}}, Published{0.40, true, {0.075327, 179.837}},
                             Published{0.15, false, {0.025625, 61.178}}, Published{0.40, false, {0.068334, 163.143}}}) {
    const Strand strand = curlew({.residual_forces = p.residual_forces});
    const Knee at_72 = knee_of(strand, p.eta, 72);
    check_close(at_72.chi_0, p.knee.chi_0, {.relative = 1e-3}, "chi_0 at 72 points");
    check_close(at_72.M_0, p.knee.M_0, {.relative = 1e-3}, "M_0 at 72 points");
    // The published figures carry five or six digits.
    const Knee at_4000 = knee_of(strand, p.eta, 4000);
    check_close(at_4000.chi_0, p.knee.chi_0, {.relative = 2.5e-5}, "chi_0 at 4000 points");
    check_close(at_4000.M_0, p.knee.M_0, {.relative = 1e-5}, "M_0 at 4000 points");
  }
}

TEST_CASE("return map: the error of the points falls with their square: 0.14 percent at 36, a quarter of it at 72") {
  for (double eta : {0.15, 0.40}) {
    const double exact = knee_of(curlew(), eta, 4000).chi_0;
    const double at_36 = knee_of(curlew(), eta, 36).chi_0 / exact - 1;
    const double at_72 = knee_of(curlew(), eta, 72).chi_0 / exact - 1;
    check_close(at_36, 1.4e-3, {.absolute = 0.1e-3});
    check_close(at_36 / at_72, 4, {.absolute = 0.05});
  }
}

TEST_CASE("return map: the full-slip moment is linear in the tension and homogeneous in all that presses") {
  // Nothing opens at these tensions, so the friction moment is a linear map of (tension, residual forces).
  const double at_10 = knee_of(curlew(), 0.1, 36).M_0;
  const double at_20 = knee_of(curlew(), 0.2, 36).M_0;
  const double at_40 = knee_of(curlew(), 0.4, 36).M_0;
  check_close(at_40 - at_20, 2 * (at_20 - at_10), {.relative = 1e-10});
  const Strand bare = curlew({.residual_forces = false});
  check_close(knee_of(bare, 0.4, 36).M_0, 4 * knee_of(bare, 0.1, 36).M_0, {.relative = 1e-10});
}

TEST_CASE("return map: the full-slip moment is nearly linear in the friction coefficient") {
  // A wire that slipped presses more on the tension side than it presses less on the other: second order in mu sin(a).
  const double at_35 = knee_of(curlew({.friction = 0.35}), 0.4, 72).M_0;
  const double at_70 = knee_of(curlew({.friction = 0.70}), 0.4, 72).M_0;
  CHECK(at_70 > 2 * at_35);
  check_close(at_70, 2 * at_35, {.relative = 0.03});
}

TEST_CASE("return map: without residual forces the loops shrink by the published parts and keep their shape") {
  // [FM2016 8.2.1]: at equal chi_max/chi_0 the area falls by about 40 % at eta = 0.15 and 20 % at 0.40, hardly
  // depending on chi_max/chi_0: "almost constant", so both factors of the area (moment and curvature) scale with chi_0.
  struct Published {
    double eta;
    double lower_by;
  };
  const Strand full = curlew();
  const Strand bare = curlew({.residual_forces = false});
  for (const Published& p : {Published{0.15, 0.40}, Published{0.40, 0.20}}) {
    for (double amplitude : {1.0, 2.0, 5.0}) {  // chi_max/chi_0
      const double with = loop_area(full, p.eta, amplitude * knee_of(full, p.eta, 36).chi_0);
      const double without = loop_area(bare, p.eta, amplitude * knee_of(bare, p.eta, 36).chi_0);
      check_close(1 - without / with, p.lower_by, {.absolute = 0.04});
    }
  }
}

TEST_CASE("return map: without friction it is EI_min, and nothing is lost") {
  const Strand strand = curlew({.friction = 0});
  const PlanarReturnMap law(strand, 36);
  const double EI_min = section_constants(strand).EI_min;
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  for (double chi : {1e-6, 0.01, 0.1, -0.3, 0.2, 0.0}) {
    for (double eps : {5e-4, 1e-4, -2e-4, 9e-4}) {
      const auto answer = point.respond({.eps = eps, .chi = chi});
      CHECK(answer.M == EI_min * chi);
      CHECK(answer.dM_dchi == EI_min);
      CHECK(answer.dM_deps == 0);
      CHECK(point.commit({.eps = eps, .chi = chi}).dissipated == 0);
    }
  }
}

TEST_CASE("return map: with friction without bound it is EI_max, and nothing is lost, while all contacts press") {
  // mu = 1000 makes 1 - b negative: no limit can be reached outward. Inward the limit is where the contact opens, which
  // the compression side reaches near 0.03 1/m at this tension.
  const Strand strand = curlew({.friction = 1000});
  const PlanarReturnMap law(strand, 36);
  const double EI_max = section_constants(strand).EI_max;
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  for (double chi : {1e-6, 0.01, 0.02, -0.02, 0.015, 0.0}) {
    const auto answer = point.respond({.eps = 5e-4, .chi = chi});
    check_close(answer.M, EI_max * chi, {.relative = 1e-12, .absolute = 1e-12});
    check_close(answer.dM_dchi, EI_max, {.relative = 1e-12});
    CHECK(point.commit({.eps = 5e-4, .chi = chi}).dissipated == 0);
  }
}

TEST_CASE("return map: the limits follow the tension: letting it go at held curvature slips and loses energy") {
  const PlanarReturnMap law(curlew(), 36);
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  point.commit({.eps = 5e-4, .chi = 0.05});
  const double M_tight = point.respond({.eps = 5e-4, .chi = 0.05}).M;
  // More tension alone changes nothing: what sticks goes on sticking.
  CHECK(point.respond({.eps = 6e-4, .chi = 0.05}).M == M_tight);
  const double M_loose = point.respond({.eps = 3e-4, .chi = 0.05}).M;
  CHECK(M_loose < 0.8 * M_tight);
  CHECK(point.respond({.eps = 3e-4, .chi = 0.05}).dM_deps > 0);
  CHECK(point.commit({.eps = 3e-4, .chi = 0.05}).dissipated > 0);
  // What slipped stays slipped when the tension comes back.
  check_close(point.respond({.eps = 5e-4, .chi = 0.05}).M, M_loose, {.relative = 1e-14});
}

TEST_CASE("return map: loss per cycle of a layer with a constant limit is the closed form, at any step size") {
  // Every cell is an elastic-perfectly-plastic spring: 4 q_lim (A cos(theta) - e_y) per cycle, e_y = q_lim/k, where
  // A cos(theta) > e_y. Summed over the cells that is exact; over theta it is
  //     (8/pi) C q_lim (A sin(theta_s) - e_y theta_s),  cos(theta_s) = e_y/A,  to O(N^-2).
  const ConstantLimit one;
  constexpr int points = 720;
  const PlanarReturnMap law(one.strand, points);
  const double e_y = one.first_slip();
  for (double amplitude : {0.5 * e_y, 1.5 * e_y, 10 * e_y}) {
    double exact_sum = 0;
    for (int i = 0; i < points / 4; ++i) {
      const double e = amplitude * std::cos((i + 0.5) * 2 * std::numbers::pi / points);
      if (e > e_y) exact_sum += one.C * 4 * one.q_lim * (e - e_y) * 4 / points;
    }
    const double slip_angle = amplitude > e_y ? std::acos(e_y / amplitude) : 0;
    const double closed_form = amplitude > e_y ? 8 / std::numbers::pi * one.C * one.q_lim *
                                                     (amplitude * std::sin(slip_angle) - e_y * slip_angle)
                                               : 0;
    for (int steps : {1, 7, 50}) {  // per half cycle
      OnePoint point(law, {.eps = 3e-4, .chi = 0});
      point.commit({.eps = 3e-4, .chi = amplitude});
      double lost = 0;
      for (int s = 1; s <= 2 * steps; ++s) {
        const double chi = amplitude * (1 - 2 * std::abs(1 - std::abs(1 - static_cast<double>(s) / steps)));
        lost += point.commit({.eps = 3e-4, .chi = chi}).dissipated;
      }
      check_close(lost, exact_sum, {.relative = 1e-11, .absolute = 1e-15}, "sum over the cells");
      // Near first slip few angles slip, and the sum over cells ends at the edge of one.
      check_close(lost, closed_form, {.relative = 1e-4}, "closed form");
    }
  }
}

TEST_CASE("return map: a layer with a constant limit slips first at q_lim/k, and at no other curvature") {
  const ConstantLimit one;
  const PlanarReturnMap law(one.strand, 720);
  const double first_cell = std::cos(std::numbers::pi / 720);
  const double first_slip = one.first_slip() / first_cell;
  const OnePoint point(law, {.eps = 3e-4, .chi = 0});
  CHECK_FALSE(point.respond({.eps = 3e-4, .chi = first_slip * (1 - 1e-12)}).swept);
  CHECK(point.respond({.eps = 3e-4, .chi = first_slip * (1 + 1e-12)}).swept);
  CHECK_FALSE(point.respond({.eps = 3e-4, .chi = -first_slip * (1 - 1e-12)}).swept);
  CHECK(point.respond({.eps = 3e-4, .chi = -first_slip * (1 + 1e-12)}).swept);
}

TEST_CASE(
    "return map: the effort counts points that marched, and the padding of a batch is neither counted nor touched") {
  // Without residual forces the padding, which has no tension, could hold nothing.
  const PlanarReturnMap law(curlew({.residual_forces = false}), 36);
  Field strains(Dimension::planar, 11);
  std::fill_n(strains[axial].begin(), 11, 5e-4);
  History history = law.start(strains);
  for (std::size_t i : {1u, 4u, 10u}) strains[bending2][i] = 0.05;
  Field stresses(Dimension::planar, 11);
  TangentField tangents(Dimension::planar, 11);
  const Effort tried = law.respond(history, strains, stresses, &tangents);
  CHECK(tried.evaluations == 11);
  CHECK(tried.sweeps == 3);
  StepEnergy energy(11);
  const Effort accepted = law.commit(history, strains, energy);
  CHECK(accepted.evaluations == 11);
  CHECK(accepted.sweeps == 3);
  for (std::size_t i = 11; i < 16; ++i) {
    CHECK(stresses[axial][i] == 0);
    CHECK(stresses[bending2][i] == 0);
    CHECK(energy.stored[i] == 0);
    CHECK(energy.dissipated[i] == 0);
    CHECK(energy.quadrature_error[i] == 0);
  }
}

TEST_CASE("return map: a strand brought straight to a curvature starts as if it had been bent there in one step") {
  const PlanarReturnMap law(curlew(), 36);
  const OnePoint bent(law, {.eps = 5e-4, .chi = 0.04});
  OnePoint bending(law, {.eps = 5e-4, .chi = 0});
  bending.commit({.eps = 5e-4, .chi = 0.04});
  for (double chi : {0.04, 0.05, 0.0, -0.02}) {
    CHECK(bent.respond({.eps = 5e-4, .chi = chi}).M == bending.respond({.eps = 5e-4, .chi = chi}).M);
  }
}

TEST_CASE("return map: the axial force is EA eps and knows nothing of bending") {
  const PlanarReturnMap law(curlew(), 36);
  const OnePoint point(law, {.eps = 5e-4, .chi = 0});
  for (double chi : {0.0, 0.03, -1.0}) {
    CHECK(point.respond({.eps = 4e-4, .chi = chi}).N == section_constants(curlew()).EA * 4e-4);
  }
}
