#include "strandyn/analysis/published_laws.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::test::check_close;

namespace {

constexpr RatedConductor drake{.diameter = 28.13e-3, .mass_per_length = 1.628, .rated_strength = 140.1e3};

const PublishedLaw& named(std::string_view name) {
  for (const PublishedLaw& law : published_laws()) {
    if (law.name == name) return law;
  }
  FAIL("no such law");
  return published_laws().front();
}

}  // namespace

TEST_CASE("published laws: the common factor of Drake is 1.863") {
  check_close(common_factor(drake), 1.863, {.absolute = 5e-4});  // the digits given
  check_close(common_factor(drake), 28.13 / std::sqrt(1.628 * 140.1), {.relative = 1e-14});
}

TEST_CASE("published laws: only the exponents of Noiseux take a factor, the common one or that of similarity") {
  int with_factor = 0;
  for (const PublishedLaw& law : published_laws()) with_factor += law_for(law, drake).has_value();
  CHECK(with_factor == 2);
  const PowerLaw law = law_for(named("Noiseux"), drake).value();
  const TestCondition at{.antinode_amplitude = 5e-3, .frequency = 20, .tension = 28e3};
  // k A^2.44 f^5.63/T^2.76 in m, Hz, kN.
  const double expected =
      std::exp(std::log(common_factor(drake)) + 2.44 * std::log(5e-3) + 5.63 * std::log(20) - 2.76 * std::log(28));
  check_close(power(law, at), expected, {.relative = 1e-12});
}

TEST_CASE(
    "published laws: by similarity the factor goes with d^4 m^2.76, and the common one is 42 times that for Hawk") {
  constexpr RatedConductor curlew{.diameter = 31.68e-3, .mass_per_length = 1.981, .rated_strength = 162.8e3};
  constexpr RatedConductor hawk{.diameter = 21.781e-3, .mass_per_length = 0.976, .rated_strength = 86.7e3};
  check_close(similarity_factor(curlew), common_factor(curlew), {.relative = 1e-14});
  check_close(common_factor(hawk) / similarity_factor(hawk), 42, {.relative = 0.02});
  RatedConductor twice = curlew;
  twice.diameter *= 2;
  twice.mass_per_length *= 4;
  check_close(std::log2(similarity_factor(twice) / similarity_factor(curlew)), 4 + 2 * 2.76, {.relative = 1e-12});
  CHECK(law_for(named("Noiseux, by similarity"), hawk)->factor == similarity_factor(hawk));
}

TEST_CASE("published laws: the band of an exponent runs from the smallest to the largest published") {
  CHECK(published_laws().size() == 9);
  const ExponentBands bands = published_bands();
  CHECK(bands.amplitude.low == 2.0);   // Claren and Diana
  CHECK(bands.amplitude.high == 2.6);  // Tompkins
  CHECK(bands.frequency.low == 4.0);   // Claren and Diana
  CHECK(bands.frequency.high == 6.0);  // Tompkins
  CHECK(bands.tension.low == 1.9);     // Tompkins
  CHECK(bands.tension.high == 2.8);    // Seppa
  CHECK_FALSE(named("Rawlins").tension.has_value());
}

TEST_CASE("published laws: inside of a band is zero and outside is signed") {
  constexpr Interval band{.low = 2, .high = 2.5};
  CHECK(outside(band, 2.0) == 0.0);
  CHECK(outside(band, 2.2) == 0.0);
  CHECK(outside(band, 2.5) == 0.0);
  check_close(outside(band, 1.7), -0.3, {.relative = 1e-14});
  check_close(outside(band, 3.0), 0.5, {.relative = 1e-14});
}

TEST_CASE("published laws: micro-slip lies outside the published exponents by known amounts") {
  PowerLawFit fit;
  fit.amplitude = Estimate{.value = 3};
  fit.frequency = Estimate{.value = 7};
  const BandComparison compared = compare_with_published(fit);
  check_close(compared.amplitude.value(), 0.4, {.relative = 1e-13});
  check_close(compared.frequency.value(), 1.0, {.relative = 1e-13});
  CHECK_FALSE(compared.tension.has_value());  // the fit had none
}
