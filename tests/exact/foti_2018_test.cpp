#include "strandyn/exact/foti_2018.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double diameter = 31.05e-3;
constexpr double frequency = 20;

/// Aster 570 at 15 % of its rated strength.
constexpr Foti2018 aster{.EI = 2155, .chi_0 = 0.140652 * 0.15, .mass_per_length = 1.571, .tension = 0.15 * 185.3e3};

double power(double amplitude_over_diameter) {
  return self_damping(aster, {.antinode_amplitude = amplitude_over_diameter * diameter, .frequency = frequency});
}

}  // namespace

TEST_CASE("Foti and Martinelli 2018: self-damping of Aster 570 at 20 Hz") {
  // Six digits are given; 0.07381786 among them is cut, not rounded.
  check_close(power(0.05), 1.15340e-3, {.absolute = 5e-9});
  check_close(power(0.2), 7.38178e-2, {.absolute = 1e-7});
  check_close(power(0.5), 1.15340, {.absolute = 5e-6});
  check_close(power(1.0), 7.82789, {.absolute = 5e-6});
  check_close(power(1.5), 18.3469, {.absolute = 5e-5});
}

TEST_CASE("Foti and Martinelli 2018: the power is the mean of the sectional losses over a half wave") {
  for (const double ratio : {0.1, 0.6, 0.62, 2.0, 40.0}) {
    const double k_squared = std::pow(2 * pi * frequency, 2) * aster.mass_per_length / aster.tension;
    const double chi = k_squared * ratio * diameter;
    constexpr int cells = 20000;
    double mean = 0;
    for (int i = 0; i < cells; ++i) mean += loss_per_cycle(aster, chi * std::sin(pi * (i + 0.5) / cells)) / cells;
    // Midpoint rule; the kink of the slope at chi_0 leaves (pi/cells)^2 = 2.5e-8 at most.
    check_close(power(ratio), frequency * mean, {.relative = 2.5e-8});
  }
}

TEST_CASE("Foti and Martinelli 2018: sectional loss is cubic, then quadratic, and continuous at chi_0") {
  check_close(loss_per_cycle(aster, aster.chi_0 / 2), 2155 * aster.chi_0 * aster.chi_0 / 16, {.relative = 1e-15});
  check_close(loss_per_cycle(aster, aster.chi_0), 2155 * aster.chi_0 * aster.chi_0 / 2, {.relative = 1e-15});
  check_close(loss_per_cycle(aster, -3 * aster.chi_0), 9 * loss_per_cycle(aster, aster.chi_0), {.relative = 1e-15});
  check_close(power(0), 0, {});
}

TEST_CASE("Foti and Martinelli 2018: exponents of amplitude and frequency are 3 and 7 below chi_0, 2 and 5 far above") {
  const auto at = [](double amplitude, double f) {
    return self_damping(aster, {.antinode_amplitude = amplitude, .frequency = f});
  };
  check_close(at(2e-3, 20) / at(1e-3, 20), 8, {.relative = 1e-14});
  check_close(at(1e-3, 40) / at(1e-3, 20), 128, {.relative = 1e-14});
  // Far above, the terms left out are of the order (chi_0/chi)^3; chi/chi_0 is 1e4 and more.
  check_close(at(400, 20) / at(200, 20), 4, {.relative = 1e-9});
  check_close(at(200, 40) / at(200, 20), 32, {.relative = 1e-9});
}
