#include "strandyn/exact/catenary.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

const CatenarySpan sloping{.span = 300, .height_difference = 60, .weight_per_length = 16};

}  // namespace

TEST_CASE("catenary: level span of twice its parameter, by hand") {
  const auto cable = Catenary::from_horizontal_tension({.span = 2, .height_difference = 0, .weight_per_length = 3}, 3);
  check_close(cable.length(), 2 * std::sinh(1.0), {.relative = 1e-15});
  check_close(cable.sag(), std::cosh(1.0) - 1, {.relative = 1e-15});
  check_close(cable.tension(1), 3, {.relative = 1e-15});
  check_close(cable.tension(0), 3 * std::cosh(1.0), {.relative = 1e-15});
  check_close(cable.height(1), 1 - std::cosh(1.0), {.relative = 1e-15});
}

TEST_CASE("catenary: a tight level span is the parabola") {
  const auto cable =
      Catenary::from_horizontal_tension({.span = 30, .height_difference = 0, .weight_per_length = 19.4}, 24.4e3);
  const double u = 19.4 * 30 / (2 * 24.4e3);  // l/(2a) = 0.012
  const double parabola = 19.4 * 30 * 30 / (8 * 24.4e3);
  check_close(cable.sag(), parabola, {.relative = u * u / 12 * 1.001});  // the next term of cosh
  check_close(cable.sag(), parabola * (1 + u * u / 12), {.relative = u * u * u * u});
  check_close(cable.length() - 30, 8 * parabola * parabola / 90, {.relative = u * u});
}

TEST_CASE("catenary: passes through both supports and hangs the sag below the chord") {
  const auto cable = Catenary::from_horizontal_tension(sloping, 12e3);
  check_close(cable.height(0), 0, {});
  check_close(cable.height(300), 60, {.relative = 1e-14});
  check_close(30 - cable.height(150), cable.sag(), {.relative = 1e-14});
}

TEST_CASE("catenary: the vertical pulls at the supports carry the weight of the cable") {
  const auto cable = Catenary::from_horizontal_tension(sloping, 12e3);
  const double vertical = cable.horizontal_tension() * (cable.slope(300) - cable.slope(0));
  check_close(vertical, 16 * cable.length(), {.relative = 1e-14});
  // Tension grows by w per metre of height.
  check_close(cable.tension(300) - cable.tension(0), 16 * 60, {.relative = 1e-12});
}

TEST_CASE("catenary: its length is the arc length of its shape") {
  const auto cable = Catenary::from_horizontal_tension(sloping, 4e3);
  double arc = 0;
  constexpr int cells = 20000;  // midpoint rule: (l/(a cells))^2/24 = 1.5e-10 of the length, and a little more
  for (int i = 0; i < cells; ++i) arc += std::sqrt(1 + std::pow(cable.slope(300 * (i + 0.5) / cells), 2)) * 300 / cells;
  check_close(arc, cable.length(), {.relative = 1e-9});
}

TEST_CASE("catenary: from its length comes back the tension it was made with") {
  for (const double tension : {500.0, 4e3, 60e3}) {
    const auto cable = Catenary::from_horizontal_tension(sloping, tension);
    const auto back = Catenary::from_length(sloping, cable.length());
    // The length differs from the chord by u^2/6, u = w l/(2 H): rounding there comes back divided by u^2/3.
    const double u = 16 * 300 / (2 * tension);
    check_close(back.horizontal_tension(), tension, {.relative = 1e-14 * (1 + 3 / (u * u))});
  }
}
