#include "strandyn/observe/swing_range.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Unknown;
using observe::DeflectionPoints;
using observe::SwingRange;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;

/// Half of the greatest distance that is found where every node draws the same ellipse with the half-axes a and b [m],
/// its long one at an angle from y.
double amplitude(double a, double b, double angle, int steps = 400) {
  const model::Model model = test::curlew_span(test::stick_law(model::Freedom::spatial),
                                               {.length = 6, .elements = 6, .freedom = model::Freedom::spatial});
  const DeflectionPoints places(model, 0);
  SwingRange range;
  range.restart(places);
  system::Vector u = test::zeros(model);
  for (int i = 0; i < steps; ++i) {
    const double phase = 2 * pi * i / steps;
    const double along = a * std::cos(phase), across = b * std::sin(phase);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      u(test::place(model, node, Unknown::y)) = along * std::cos(angle) - across * std::sin(angle);
      u(test::place(model, node, Unknown::z)) = along * std::sin(angle) + across * std::cos(angle);
    }
    range.widen(places, u.data());
  }
  return range.largest();
}

}  // namespace

TEST_CASE("swing range: a line has its length at any angle") {
  for (const double angle : {0.0, 0.2, pi / 4, 1.1, pi / 2, 2.3}) {
    CAPTURE(angle);
    check_close(amplitude(4e-3, 0, angle), 4e-3, {.relative = 1e-12});
  }
}

TEST_CASE("swing range: a circle has its radius and an ellipse its long half-axis") {
  check_close(amplitude(3e-3, 3e-3, 0.3), 3e-3, {.relative = 1e-3});
  for (const double ratio : {0.1, 0.5, 0.8, 0.95}) {
    for (const double angle : {0.0, 0.1, 0.2, 0.37}) {
      CAPTURE(ratio);
      CAPTURE(angle);
      const double found = amplitude(1e-3, ratio * 1e-3, angle);
      CHECK(found <= 1e-3 * (1 + 1e-12));
      check_close(found, 1e-3, {.relative = 5e-3});
    }
  }
}
