#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/one_point.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/return_map.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::test::check_close;
using strandyn::test::OnePoint;

namespace {

/// The second of two symmetric cycles.
struct Loop {
  double area = 0;    ///< [J/m] lost per cycle
  double secant = 0;  ///< [N m^2] at the tip
};

Loop loop_of(const Law& law, double eps, double amplitude) {
  constexpr int steps = 400;  // per cycle, from tip to tip
  OnePoint section(law, {.eps = eps, .chi = 0});
  Loop loop;
  section.commit({.eps = eps, .chi = amplitude});
  for (int n = 1; n <= 2 * steps; ++n) {
    const double chi = amplitude * std::cos(2 * std::numbers::pi * n / steps);
    if (n == 2 * steps) loop.secant = section.respond({.eps = eps, .chi = chi}).M / chi;
    const double lost = section.commit({.eps = eps, .chi = chi}).dissipated;
    if (n > steps) loop.area += lost;
  }
  return loop;
}

/// [N m] friction part where every angle slips.
double full_slip_moment(const Law& law, double eps, double EI_min) {
  constexpr double far = 100;  // [1/m]
  return OnePoint(law, {.eps = eps, .chi = 0}).respond({.eps = eps, .chi = far}).M - EI_min * far;
}

double percent(double got, double reference) {
  return 100 * (got / reference - 1);
}

}  // namespace

TEST_CASE("masing: frozen limits change Curlew's loops by less than one per cent, full slip by less than two") {
  const auto strand = strandyn::test::curlew();
  const auto constants = strandyn::conductor::section_constants(strand);
  const MasingLaw masing(strand);
  const PlanarReturnMap return_map(strand, 720);
  for (double eta : {0.05, 0.1, 0.15, 0.2, 0.3, 0.4}) {
    const double eps = eta * 162.8e3 / constants.EA;
    const double M_frozen = full_slip_moment(masing, eps, constants.EI_min);
    const double M_moving = full_slip_moment(return_map, eps, constants.EI_min);
    MESSAGE(fmt::format("eta {:.2f}: full-slip moment {:.5g}, return map {:.5g} N m ({:+.2f} %)", eta, M_frozen,
                        M_moving, percent(M_frozen, M_moving)));
    check_close(M_frozen, M_moving, {.relative = 0.02}, "full-slip moment");
    const double chi_0 = M_moving / (constants.EI_max - constants.EI_min);
    for (double ratio : {0.3, 0.4, 0.5, 1.0, 2.0, 4.0}) {
      const Loop m = loop_of(masing, eps, ratio * chi_0);
      const Loop r = loop_of(return_map, eps, ratio * chi_0);
      MESSAGE(
          fmt::format("  {:.1f} chi_0: area {:.5g}, return map {:.5g} J/m ({:+.2f} %); secant {:.5g}, {:.5g} N m^2 "
                      "({:+.2f} %)",
                      ratio, m.area, r.area, percent(m.area, r.area), m.secant, r.secant, percent(m.secant, r.secant)));
      // Nearer to the first slip both areas go to zero, each at its own threshold.
      if (ratio >= 0.4) check_close(m.area, r.area, {.relative = 0.01}, "loop area");
      check_close(m.secant, r.secant, {.relative = 0.01}, "secant stiffness");
    }
  }
}
