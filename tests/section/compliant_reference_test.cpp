// The compliant law against itself written another way, and its chains against the curves they stand for.
#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/one_point.hpp"
#include "section/plain_compliant.hpp"
#include "section/random_paths.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::OnePoint;
using strandyn::test::PlainCompliant;
using strandyn::test::Random;
using strandyn::test::steel_1x6;

TEST_CASE("compliant law: equals the plain one on random paths with moving tension and opening contacts") {
  const CompliantOptions options{.points = 16, .springs = 7, .smallest_slip = 1e-2};
  std::uint64_t stream = 40;
  for (const Strand& strand : {curlew(), curlew({.friction = 0.3, .residual_forces = false}), steel_1x6()}) {
    const CompliantLaw law(strand, options);
    Random random(++stream);
    const double EI = section_constants(strand).EI_max;
    for (double width : {0.002, 0.02, 0.1}) {
      OnePoint point(law, {.eps = 5e-4, .chi = 0});
      PlainCompliant plain(strand, options, 5e-4);
      double before = plain.step({.eps = 5e-4, .chi = 0}).stored;
      double chi = 0;
      for (int s = 0; s < 40; ++s) {
        chi += width * random.between(-1, 1);
        const double eps = 5e-4 * random.between(-0.3, 2);
        const double M = point.respond({.eps = eps, .chi = chi}).M;
        const auto loss = point.commit({.eps = eps, .chi = chi});
        const auto expected = plain.step({.eps = eps, .chi = chi});
        // Halving stops at 1e-16 m of slip, some 1e-6 N/m of a limit of 1e3 or more.
        check_close(M, expected.M, {.absolute = 1e-8 * EI * 0.1}, "M");
        check_close(loss.stored, expected.stored, {.relative = 1e-8}, "stored");
        check_close(loss.dissipated - loss.quadrature_error, expected.lost, {.absolute = 1e-8 * before}, "loss");
        before = expected.stored;
      }
    }
  }
}

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
