#include "strandyn/air/gusts.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/check_close.hpp"

using strandyn::air::Gusts;
using strandyn::air::Turbulence;
using strandyn::test::check_close;

namespace {

constexpr Turbulence breeze{.intensity = 0.12, .length = 80, .speed = 4, .highest = 2, .seed = 7};

}  // namespace

TEST_CASE("gusts: mean, intensity and length scale are those asked for") {
  const Gusts gusts(breeze);
  check_close(gusts.variance(), 0.12 * 0.12, {.relative = 1e-12});
  double sum = 0, squares = 0, beside = 0;
  constexpr int samples = 400000;
  constexpr double step = 0.5, lag = 10;  // half of L/U
  for (int i = 0; i < samples; ++i) {
    const double u = gusts.at(i * step) - 1;
    sum += u;
    squares += u * u;
    beside += u * (gusts.at(i * step + lag) - 1);
  }
  check_close(sum / samples, 0, {.absolute = 2e-3});
  check_close(squares / samples, 0.12 * 0.12, {.relative = 0.03});
  // Von Karman's correlation at r = U lag = L/2: 2^(2/3)/Gamma(1/3) z^(1/3) K_(1/3)(z), z = 0.747 r/L.
  const double z = 0.747 * 0.5;
  const double expected = std::pow(2, 2.0 / 3) / std::tgamma(1.0 / 3) * std::cbrt(z) * std::cyl_bessel_k(1.0 / 3, z);
  check_close(beside / squares, expected, {.absolute = 0.03});
}

TEST_CASE("gusts: a seed is one record, none is a steady wind") {
  const Gusts one(breeze), same(breeze), none;
  Turbulence another = breeze;
  another.seed = 8;
  const Gusts other(another);
  CHECK(one.at(12.5) == same.at(12.5));
  CHECK(one.at(12.5) != other.at(12.5));
  CHECK(none.at(12.5) == 1);
  CHECK(none.variance() == 0);
}
