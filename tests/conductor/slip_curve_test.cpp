#include "strandyn/conductor/slip_curve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::conductor;
using strandyn::test::check_close;

TEST_CASE("slip curve: a spot's is Cattaneo and Mindlin's, with the classical loss at small slip") {
  const SlipCurve spot = SlipCurve::spot();
  CHECK(spot.traction(0) == 0);
  CHECK(spot.traction(1) == 1);
  CHECK(spot.slope(0) == 1.5);
  CHECK(spot.loss_moment(1) == 1);
  check_close(spot.traction(0.36), 1 - 0.512, {.relative = 1e-15});
  check_close(spot.loss_moment(1e-3), 3.0 / 8 * 1e-6, {.relative = 1e-3}, "leading term");
}

TEST_CASE("slip curve: a line's obeys Cattaneo's antiplane slip, and its slope and loss at small slip follow") {
  constexpr double Lambda = 6;
  const SlipCurve line = SlipCurve::line(Lambda);
  for (double y : {0.99, 0.6, 0.2, 1e-3}) {
    const double x = (1 - y) + y * std::log(y) / (2 * Lambda);
    check_close(line.traction(x), 1 - y, {.relative = 1e-13});
    const double h = 1e-6;
    check_close(line.slope(x), (line.traction(x + h * (1 - x)) - line.traction(x - h * (1 - x))) / (2 * h * (1 - x)),
                {.relative = 1e-6});
  }
  CHECK(line.traction(1) == 1);
  CHECK(line.loss_moment(1) == 1);
  const double first = 1 / (1 - 1 / (2 * Lambda));
  check_close(line.slope(0), first, {.relative = 1e-15});
  check_close(line.loss_moment(1e-3), std::pow(first, 3) / (4 * Lambda) * 1e-6, {.relative = 1e-3}, "leading term");
}

TEST_CASE("spring chain: keeps the first stiffness and the limit, and lies within 4 % of the limit of its curve") {
  for (const SlipCurve& curve : {SlipCurve::spot(), SlipCurve::line(6)}) {
    for (double phase : {0.0, 0.3, 0.99}) {
      const SpringChain chain = spring_chain(curve, {.phase = phase});
      double stiffness = 0;
      double limit = 0;
      double reached = 0;  // slip at which the previous spring slides
      for (std::size_t i = 0; i < chain.limit.size(); ++i) {
        CHECK(chain.limit[i] > 0);
        const double reach = chain.limit[i] / chain.stiffness[i] / curve.slope(0);
        CHECK(reach > reached);
        CHECK(reach < 1);
        reached = reach;
        stiffness += chain.stiffness[i];
        limit += chain.limit[i];
      }
      check_close(stiffness, 1, {.absolute = 1e-14});
      check_close(limit, 1, {.absolute = 1e-14});
      double off = 0;
      for (double x = 0; x <= 1; x += 1e-3) {
        double traction = 0;
        for (std::size_t i = 0; i < chain.limit.size(); ++i) {
          traction += std::min(chain.stiffness[i] * curve.slope(0) * x, chain.limit[i]);
        }
        off = std::max(off, std::abs(traction - curve.traction(x)));
      }
      CAPTURE(off);
      CHECK(off < 0.04);
    }
  }
}

TEST_CASE("spring chain: over all phases a small amplitude loses what the curve says") {
  // Amplitude x loses 4 sum of limit (x - reach); the curve 4/3 c x^3, c its loss moment over x^2. Sixteen phases.
  for (const SlipCurve& curve : {SlipCurve::spot(), SlipCurve::line(6)}) {
    for (double x : {3e-4, 2e-3, 5e-3}) {
      double loss = 0;
      for (int p = 0; p < 16; ++p) {
        const SpringChain chain = spring_chain(curve, {.phase = p / 16.0});
        for (std::size_t i = 0; i < chain.limit.size(); ++i) {
          const double reach = chain.limit[i] / chain.stiffness[i] / curve.slope(0);
          loss += 4 * chain.limit[i] * std::max(0.0, x - reach) / 16;
        }
      }
      const double exact = 4.0 / 3 * curve.loss_moment(1e-4) / 1e-8 * x * x * x;
      // The next term of the curve is x/4 of this one for a spot, the end of the chain at 3e-5 adds 1 % at 3e-4.
      check_close(loss, exact, {.relative = 0.012});
    }
  }
}
