#include "strandyn/exact/friction_layer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr FrictionLayer layer{.EI_c = 600, .chi_cr = 0.01};

/// The other way: elastic-perfectly-plastic elements at many angles, driven along a path of the curvature vector.
class Elements {
 public:
  explicit Elements(int count) : q_(count, 0.0) {}

  /// Moves to (chi2, chi3); returns the dissipation of the step per unit length.
  double move_to(double chi2, double chi3) {
    double loss = 0;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const double theta = angle(i);
      const double delta = std::cos(theta) * (chi2 - chi2_) + std::sin(theta) * (chi3 - chi3_);
      const double trial = q_[i] + delta;
      q_[i] = std::clamp(trial, -layer.chi_cr, layer.chi_cr);
      loss += q_[i] * (trial - q_[i]);
    }
    chi2_ = chi2;
    chi3_ = chi3;
    return 2 * layer.EI_c * loss / static_cast<double>(q_.size());  // mean(cos^2) = 1/2 makes EI_c of 2 EI_c
  }

  double moment() const {
    double sum = 0;
    for (std::size_t i = 0; i < q_.size(); ++i) sum += std::cos(angle(i)) * q_[i];
    return 2 * layer.EI_c * sum / static_cast<double>(q_.size());
  }

 private:
  double angle(std::size_t i) const { return 2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(q_.size()); }

  std::vector<double> q_;  // over k
  double chi2_ = 0;
  double chi3_ = 0;
};

constexpr int many = 4000;
// Kinks in theta make the mean over the elements good to (2 pi/many)^2, times a number below one.
constexpr double of_the_mean = 2.5e-6;

}  // namespace

TEST_CASE("friction layer: virgin curve is linear to first slip and tends to 4/pi EI_c chi_cr") {
  check_close(virgin_moment(layer, 0.01), 6, {.relative = 1e-15});
  check_close(virgin_moment(layer, 0.02), 2 / pi * 6 * (std::sqrt(0.75) + 2 * pi / 6), {.relative = 1e-15});
  check_close(virgin_moment(layer, -0.02), -virgin_moment(layer, 0.02), {});
  check_close(virgin_moment(layer, 10), limit_moment(layer), {.relative = 1e-6 / 6 * 1.01});  // 1/(6 x^2) below
  check_close(virgin_moment({.EI_c = 600, .chi_cr = 0}, 0.1), 0, {});
}

TEST_CASE("friction layer: virgin tangent is the derivative of the virgin curve") {
  for (const double chi : {0.004, 0.0101, 0.03, -0.2}) {
    const double h = 1e-6;
    const double quotient = (virgin_moment(layer, chi + h) - virgin_moment(layer, chi - h)) / (2 * h);
    // Truncation h^2 M'''/6; M''' is largest just above first slip, where measured 1e-3.
    check_close(quotient, virgin_tangent(layer, chi), {.absolute = std::abs(chi) < 0.011 ? 2e-3 : 1e-6});
  }
}

TEST_CASE("friction layer: virgin curve, reversal and reloading are those of many elements") {
  Elements elements(many);
  elements.move_to(0.035, 0);
  const MomentCurvature top{.chi = 0.035, .M = virgin_moment(layer, 0.035)};
  check_close(elements.moment(), top.M, {.relative = of_the_mean});
  elements.move_to(-0.011, 0);
  const MomentCurvature bottom{.chi = -0.011, .M = masing_moment(layer, top, -0.011)};
  check_close(elements.moment(), bottom.M, {.absolute = of_the_mean * top.M});
  elements.move_to(0.02, 0);
  check_close(elements.moment(), masing_moment(layer, bottom, 0.02), {.absolute = of_the_mean * top.M});
  check_close(masing_moment(layer, top, -0.035), -top.M, {.relative = 1e-14});
}

TEST_CASE("friction layer: loss per cycle is the area of the Masing loop") {
  for (const double amplitude : {0.0101, 0.015, 0.08}) {
    const MomentCurvature top{.chi = amplitude, .M = virgin_moment(layer, amplitude)};
    double area = 0;
    constexpr int cells = 20000;
    const double h = 2 * amplitude / cells;
    // Down the one branch and up its mirror image; midpoint rule, h^2/12 times the change of slope, EI_c at most.
    for (int i = 0; i < cells; ++i) area -= 2 * masing_moment(layer, top, amplitude - (i + 0.5) * h) * h;
    check_close(area, loss_per_cycle(layer, amplitude), {.absolute = h * h / 6 * layer.EI_c}, "area");
  }
}

TEST_CASE("friction layer: loss is nothing up to first slip, then a power 3/2, then rigid-plastic") {
  check_close(loss_per_cycle(layer, 0.01), 0, {});
  const double t = std::sqrt(2e-8);
  check_close(loss_per_cycle(layer, 0.01 * (1 + 1e-8)), 16 / pi * 600 * 1e-4 * t * t * t / 3, {.relative = 2e-8});
  // 4 chi M_inf less the elastic part: (pi/2)/x below, for x = 1e4.
  check_close(loss_per_cycle(layer, 100), 4 * 100 * limit_moment(layer), {.relative = pi / 2 * 1e-4});
  // Both forms of t - atan(t) meet at t = 0.1.
  const double x = std::sqrt(1.01);
  check_close(loss_per_cycle(layer, 0.01 * x * (1 + 1e-12)), loss_per_cycle(layer, 0.01 * x * (1 - 1e-12)),
              {.relative = 1e-9});
}

TEST_CASE("friction layer: on a circular orbit every angle loses the same") {
  const double chi = 0.025;
  Elements elements(many);
  constexpr int steps = 3600;
  double loss = 0;
  for (int turn = 0; turn < 2; ++turn) {
    loss = 0;
    for (int i = 1; i <= steps; ++i)
      loss += elements.move_to(chi * std::cos(2 * pi * i / steps), chi * std::sin(2 * pi * i / steps));
  }
  // A polygon of 3600 sides misses the extremes of every angle by chi (pi/3600)^2/2 at most.
  check_close(loss, loss_per_orbit(layer, chi), {.relative = 1e-6});
  check_close(loss_per_orbit(layer, 0.009), 0, {});
}

TEST_CASE("friction layer: the layers of a strand carry its EI_max and slip first where Papailiou says") {
  const auto strand = test::curlew();
  const auto constants = conductor::section_constants(strand);
  const auto layers = friction_layers(strand, conductor::axial_wire_forces(strand, 24.4e3 / constants.EA, 0));
  REQUIRE(layers.size() == 4);
  double sum = constants.EI_min;
  for (const auto& each : layers) sum += each.EI_c;
  check_close(sum, constants.EI_max, {.relative = 1e-14});

  const auto single = test::steel_1x6();
  const double eps = 13.7e3 / conductor::section_constants(single).EA;
  const auto one = friction_layers(single, conductor::axial_wire_forces(single, eps, 0));
  check_close(one[0].chi_cr, 0.026367, {.absolute = 5e-7});  // [Papailiou1997], six decimals given
}
