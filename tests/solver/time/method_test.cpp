#include "strandyn/solver/time/method.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn;
using solver::GeneralizedAlpha;
using solver::Ida;
using solver::TimeMethod;
using test::check_close;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("methods of integration: what they do to a mode goes with the third and the second power of the step") {
  for (const TimeMethod& method : {TimeMethod(Ida{}), TimeMethod(GeneralizedAlpha{.rho_inf = 0.8})}) {
    CAPTURE(name_of(method));
    check_close(damping_ratio(method, 0.2), 8 * damping_ratio(method, 0.1), {.relative = 1e-12});
    check_close(frequency_error(method, 0.2), 4 * frequency_error(method, 0.1), {.relative = 1e-12});
  }
  check_close(damping_ratio(Ida{}, 0.1), 1e-3 / 4, {.relative = 1e-12});
  check_close(frequency_error(Ida{}, 0.1), -1e-2 / 3, {.relative = 1e-12});
}

TEST_CASE("methods of integration: the steps keep the method's share in the damping") {
  const solver::StepDemand demand{.damping_ratio = 1e-3, .share = 0.01};
  for (const TimeMethod& method : {TimeMethod(Ida{}), TimeMethod(GeneralizedAlpha{.rho_inf = 0.2})}) {
    CAPTURE(name_of(method));
    const int steps = steps_for(method, demand);
    CHECK(steps % 4 == 0);
    CHECK(damping_ratio(method, 2 * pi / steps) <= demand.share * demand.damping_ratio);
  }
  // Nothing is known of the damping, or the method has none of its own: the least that shows friction.
  CHECK(steps_for(Ida{}, {}) == 400);
  CHECK(steps_for(GeneralizedAlpha{.rho_inf = 1}, demand) == 200);
}
