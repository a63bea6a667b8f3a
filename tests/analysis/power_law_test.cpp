#include "strandyn/analysis/power_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::test::check_close;

namespace {

constexpr PowerLaw known{.factor = 1.863, .amplitude = 2.44, .frequency = 5.63, .tension = 2.76};

struct Grid {
  std::vector<double> amplitudes{1e-3, 2e-3, 5e-3, 8e-3};
  std::vector<double> frequencies{12, 20, 33};
  std::vector<double> tensions{21e3, 28e3, 35e3};

  std::vector<SelfDampingPoint> points(const PowerLaw& law = known) const {
    std::vector<SelfDampingPoint> all;
    for (const double T : tensions) {
      for (const double f : frequencies) {
        for (const double A : amplitudes) {
          const TestCondition at{.antinode_amplitude = A, .frequency = f, .tension = T};
          all.push_back({.at = at, .power = power(law, at)});
        }
      }
    }
    return all;
  }
};

}  // namespace

TEST_CASE("power law: an exact law is found again to rounding") {
  const PowerLawFit fit = fit_power_law(Grid{}.points());
  CHECK(fit.points == 36);
  const PowerLaw law = fit.law().value();
  check_close(law.amplitude, 2.44, {.relative = 1e-12});
  check_close(law.frequency, 5.63, {.relative = 1e-12});
  check_close(law.tension, 2.76, {.relative = 1e-12});
  check_close(law.factor, 1.863, {.relative = 1e-11});
  check_close(fit.r_squared.value(), 1, {.relative = 1e-14});
  check_close(fit.scatter, 0, {.absolute = 1e-13});
  CHECK(fit.amplitude->standard_error.value() < 1e-13);
}

TEST_CASE("power law: tension counts in kilonewtons and amplitude in metres") {
  check_close(power({.factor = 3, .amplitude = 2, .frequency = 1, .tension = 1},
                    {.antinode_amplitude = 0.01, .frequency = 20, .tension = 30e3}),
              3 * 1e-4 * 20 / 30, {.relative = 1e-14});
}

TEST_CASE("power law: one line through four points gives the textbook's slope and errors") {
  // ln A = 0, 1, 2, 3 and ln P = 1, 3, 4, 8: slope 2.2, intercept 0.7, residuals 0.3, 0.1, -1.1, 0.7.
  std::vector<SelfDampingPoint> points;
  const double ln_P[] = {1, 3, 4, 8};
  for (int i = 0; i < 4; ++i) {
    points.push_back(
        {.at = {.antinode_amplitude = std::exp(i), .frequency = 1, .tension = 1000}, .power = std::exp(ln_P[i])});
  }
  const PowerLawFit fit = fit_power_law(points);
  const double s2 = 1.8 / 2;  // residual square over two degrees of freedom
  check_close(fit.amplitude->value, 2.2, {.relative = 1e-13});
  check_close(fit.amplitude->standard_error.value(), std::sqrt(s2 / 5), {.relative = 1e-13});
  check_close(fit.log_factor->value, 0.7, {.relative = 1e-12});
  check_close(fit.log_factor->standard_error.value(), std::sqrt(s2 * (0.25 + 2.25 / 5)), {.relative = 1e-13});
  check_close(fit.r_squared.value(), 1 - 1.8 / 26, {.relative = 1e-13});
  check_close(fit.scatter, std::sqrt(1.8 / 4), {.relative = 1e-13});
  const double t = 4.302652729749464;  // two degrees of freedom
  check_close(fit.amplitude->interval_95->high - 2.2, t * std::sqrt(s2 / 5), {.relative = 1e-13});
  check_close(2.2 - fit.amplitude->interval_95->low, t * std::sqrt(s2 / 5), {.relative = 1e-13});
}

TEST_CASE("power law: intervals hold the true exponents in 95 of 100 noisy series") {
  std::mt19937 random(20261122);
  std::normal_distribution<double> noise(0, 0.2);
  // Tension and frequency vary together in part, as on a span whose modes are taken.
  std::vector<SelfDampingPoint> exact;
  for (int i = 0; i < 12; ++i) {
    const TestCondition at{
        .antinode_amplitude = 1e-3 * (1 + i % 4), .frequency = 10 + 2.0 * i, .tension = 20e3 + 1e3 * i + (i % 3) * 2e3};
    exact.push_back({.at = at, .power = power(known, at)});
  }
  constexpr int series = 4000;
  int l = 0, m = 0, n = 0, k = 0;
  for (int s = 0; s < series; ++s) {
    std::vector<SelfDampingPoint> noisy = exact;
    for (SelfDampingPoint& p : noisy) p.power *= std::exp(noise(random));
    const PowerLawFit fit = fit_power_law(noisy);
    const auto holds = [](const Estimate& e, double value) {
      return e.interval_95->low <= value && value <= e.interval_95->high;
    };
    l += holds(*fit.amplitude, known.amplitude);
    m += holds(*fit.frequency, known.frequency);
    n += holds(*fit.tension, known.tension);
    k += holds(*fit.log_factor, std::log(known.factor));
  }
  // Four standard deviations of a count of 4000: 4 sqrt(0.95 . 0.05/4000) = 0.0138.
  for (const int count : {l, m, n, k}) check_close(count / double(series), 0.95, {.absolute = 0.0138});
}

TEST_CASE("power law: the exponent of a variable that does not vary is absent and the factor holds there") {
  Grid grid;
  grid.tensions = {28e3};
  std::vector<SelfDampingPoint> points = grid.points();
  for (int i = 0; i < 12; ++i) points[i].at.tension *= 1 + 1e-6 * i;  // what a simulation settles at
  const PowerLawFit fit = fit_power_law(points);
  CHECK_FALSE(fit.tension.has_value());
  check_close(fit.amplitude->value, 2.44, {.relative = 1e-12});
  check_close(fit.frequency->value, 5.63, {.relative = 1e-12});
  check_close(fit.law()->factor, 1.863 * std::pow(28, -2.76), {.relative = 1e-11});
  CHECK(fit.law()->tension == 0.0);
}

TEST_CASE("power law: exponents of variables that vary together are absent and the others stand") {
  // One mode at several tensions: the frequency follows the root of the tension.
  Grid grid;
  grid.frequencies = {1};
  std::vector<SelfDampingPoint> points = grid.points();
  for (SelfDampingPoint& p : points) {
    p.at.frequency = std::sqrt(p.at.tension);
    p.power = power(known, p.at);
  }
  const PowerLawFit fit = fit_power_law(points);
  CHECK_FALSE(fit.frequency.has_value());
  CHECK_FALSE(fit.tension.has_value());
  CHECK_FALSE(fit.log_factor.has_value());
  CHECK_FALSE(fit.law().has_value());
  check_close(fit.amplitude->value, 2.44, {.relative = 1e-12});
  check_close(fit.r_squared.value(), 1, {.relative = 1e-13});
}

TEST_CASE("power law: as many points as parameters give exponents without errors and fewer give none") {
  const std::vector<SelfDampingPoint> all = Grid{}.points();
  const std::vector<SelfDampingPoint> four{all[0], all[1], all[4], all[12]};  // a base point and a step along each
  const PowerLawFit fit = fit_power_law(four);
  check_close(fit.tension->value, 2.76, {.relative = 1e-12});
  CHECK_FALSE(fit.tension->standard_error.has_value());
  CHECK_FALSE(fit.tension->interval_95.has_value());
  const std::vector<SelfDampingPoint> two{all[0], all[17]};  // all three variables at once
  const PowerLawFit poor = fit_power_law(two);
  CHECK_FALSE(poor.amplitude.has_value());
  CHECK_FALSE(poor.frequency.has_value());
  CHECK_FALSE(poor.tension.has_value());
  const PowerLawFit one = fit_power_law(std::vector{all[3]});
  CHECK_FALSE(one.amplitude.has_value());
  check_close(one.law()->factor, all[3].power, {.relative = 1e-14});
  CHECK_FALSE(one.r_squared.has_value());
  CHECK(fit_power_law({}).points == 0);
  CHECK_FALSE(fit_power_law({}).law().has_value());
}

TEST_CASE("power law: points without loss are counted and give the amplitude below which nothing slips") {
  std::vector<SelfDampingPoint> points = Grid{}.points();
  for (SelfDampingPoint& p : points) {
    if (p.at.antinode_amplitude < 3e-3) p.power = 0;                              // 1 and 2 mm
    if (p.at.antinode_amplitude > 3e-3 && p.at.tension > 34e3) p.power = -1e-18;  // some of 5 and 8 mm
  }
  const PowerLawFit fit = fit_power_law(points);
  CHECK(fit.points == 12);
  CHECK(fit.without_loss == 24);
  check_close(fit.no_slip_below.value(), 2e-3, {});  // 5 mm loses at the other tensions
  check_close(fit.amplitude->value, 2.44, {.relative = 1e-11});
  // All zero: the largest amplitude of all; none zero: no such amplitude.
  for (SelfDampingPoint& p : points) p.power = 0;
  check_close(fit_power_law(points).no_slip_below.value(), 8e-3, {});
  CHECK(fit_power_law(points).points == 0);
  CHECK_FALSE(fit_power_law(Grid{}.points()).no_slip_below.has_value());
}

TEST_CASE("power law: a failed point is left out and counted") {
  std::vector<SelfDampingPoint> points = Grid{}.points();
  points[2].power = std::nan("");
  points[5].at.tension = 0;
  const PowerLawFit fit = fit_power_law(points);
  CHECK(fit.unusable == 2);
  CHECK(fit.points == 34);
  check_close(fit.frequency->value, 5.63, {.relative = 1e-12});
}

TEST_CASE("power law: a band of amplitudes takes both of its ends and nothing beyond") {
  // Cubic below 3 mm, square above, as a law of partial and of full slip.
  std::vector<SelfDampingPoint> points;
  for (const double A : {1e-3, 2e-3, 3e-3, 4e-3, 6e-3}) {
    points.push_back({.at = {.antinode_amplitude = A, .frequency = 20, .tension = 28e3},
                      .power = A <= 3e-3 ? 1e6 * A * A * A : 3e3 * A * A});
  }
  const PowerLawFit low = fit_power_law(points, {.highest = std::nextafter(3e-3, 0)});  // but for rounding
  CHECK(low.points == 3);
  check_close(low.amplitude->value, 3, {.relative = 1e-12});
  const PowerLawFit high = fit_power_law(points, {.lowest = 3e-3});
  CHECK(high.points == 3);
  check_close(high.amplitude->value, 2, {.relative = 1e-12});
}

TEST_CASE("power law: a factor beyond what a number can hold is none, the exponents stay") {
  // Two frequencies 1.5 % apart, on both sides of the onset of slip: f^1809, and k = 0.5/20.3^1809.
  const PowerLawFit steep =
      fit_power_law({{{.at = {.antinode_amplitude = 4e-3, .frequency = 20, .tension = 28e3}, .power = 1e-12},
                      {.at = {.antinode_amplitude = 4e-3, .frequency = 20.3, .tension = 28e3}, .power = 0.5}}});
  check_close(steep.frequency->value, std::log(0.5e12) / std::log(20.3 / 20), {.relative = 1e-9});
  CHECK(steep.log_factor.has_value());
  CHECK_FALSE(steep.law().has_value());
}

TEST_CASE("Student: one and two degrees of freedom have closed forms and many give the normal distribution") {
  for (const double p : {0.5, 0.9, 0.95, 0.999}) {
    check_close(student_t(1, p), std::tan(std::numbers::pi * p / 2), {.relative = 1e-12});
    check_close(student_t(2, p), p * std::sqrt(2 / (1 - p * p)), {.relative = 1e-12});
  }
  // z + (z^3 + z)/(4 degrees) + ..., z = 1.959963984540054.
  const double z = 1.959963984540054;
  check_close(student_t(100000, 0.95), z + (z * z * z + z) / 4e5, {.absolute = 1e-9});
}

TEST_CASE("Student: the density over the interval adds up to the confidence") {
  for (const int degrees : {3, 4, 5, 10, 31, 250}) {
    const double t = student_t(degrees, 0.95);
    const double scale =
        std::exp(std::lgamma((degrees + 1) / 2.0) - std::lgamma(degrees / 2.0)) / std::sqrt(degrees * std::numbers::pi);
    const auto density = [&](double x) { return scale * std::pow(1 + x * x / degrees, -(degrees + 1) / 2.0); };
    constexpr int cells = 400;  // Simpson; its error here is below 1e-10
    double sum = density(0) + density(t);
    for (int i = 1; i < cells; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(t * i / cells);
    check_close(2 * sum * t / (3 * cells), 0.95, {.absolute = 1e-10});
  }
}
