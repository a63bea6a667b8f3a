#include "strandyn/analysis/published_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace strandyn::analysis {
namespace {

constexpr Interval exactly(double value) {
  return {.low = value, .high = value};
}

constexpr std::array<PublishedLaw, 9> laws{{
    {.name = "Claren & Diana", .amplitude = exactly(2.0), .frequency = exactly(4.0), .tension = exactly(2.5)},
    {.name = "Seppa", .amplitude = exactly(2.5), .frequency = exactly(5.75), .tension = exactly(2.8)},
    {.name = "Rawlins", .amplitude = exactly(2.2), .frequency = exactly(5.4)},
    {.name = "Kraus & Hagedorn", .amplitude = exactly(2.47), .frequency = exactly(5.38), .tension = exactly(2.8)},
    {.name = "Noiseux",
     .amplitude = exactly(2.44),
     .frequency = exactly(5.63),
     .tension = exactly(2.76),
     .takes_common_factor = true},
    {.name = "Noiseux, by similarity",
     .amplitude = exactly(2.44),
     .frequency = exactly(5.63),
     .tension = exactly(2.76),
     .takes_similarity = true},
    {.name = "Moecks & Schmidt", .amplitude = exactly(2.45), .frequency = exactly(5.38), .tension = exactly(2.4)},
    {.name = "Politecnico di Milano", .amplitude = exactly(2.43), .frequency = exactly(5.5), .tension = exactly(2.0)},
    {.name = "Tompkins", .amplitude = {2.3, 2.6}, .frequency = {5.0, 6.0}, .tension = exactly(1.9)},
}};

void widen(Interval& band, const Interval& by) {
  band.low = std::min(band.low, by.low);
  band.high = std::max(band.high, by.high);
}

}  // namespace

std::span<const PublishedLaw> published_laws() {
  return laws;
}

double common_factor(const RatedConductor& conductor) {
  return 1e3 * conductor.diameter / std::sqrt(conductor.mass_per_length * conductor.rated_strength / 1e3);
}

double similarity_factor(const RatedConductor& conductor) {
  constexpr RatedConductor curlew{.diameter = 31.68e-3, .mass_per_length = 1.981, .rated_strength = 162.8e3};
  constexpr double wave = 5.52;
  return common_factor(curlew) * std::pow(conductor.diameter / curlew.diameter, 4) *
         std::pow(conductor.mass_per_length / curlew.mass_per_length, wave / 2);
}

std::optional<PowerLaw> law_for(const PublishedLaw& published, const RatedConductor& conductor) {
  if (!(published.takes_common_factor || published.takes_similarity) || !published.tension) return {};
  return PowerLaw{.factor = published.takes_similarity ? similarity_factor(conductor) : common_factor(conductor),
                  .amplitude = published.amplitude.low,
                  .frequency = published.frequency.low,
                  .tension = published.tension->low};
}

ExponentBands published_bands() {
  ExponentBands bands{.amplitude = laws[0].amplitude, .frequency = laws[0].frequency, .tension = *laws[0].tension};
  for (const PublishedLaw& law : laws) {
    widen(bands.amplitude, law.amplitude);
    widen(bands.frequency, law.frequency);
    if (law.tension) widen(bands.tension, *law.tension);
  }
  return bands;
}

double outside(const Interval& band, double value) {
  return value - std::clamp(value, band.low, band.high);
}

BandComparison compare_with_published(const PowerLawFit& fit) {
  const auto compare = [](const Interval& band, const std::optional<Estimate>& exponent) {
    return exponent ? std::optional(outside(band, exponent->value)) : std::nullopt;
  };
  const ExponentBands bands = published_bands();
  return {.amplitude = compare(bands.amplitude, fit.amplitude),
          .frequency = compare(bands.frequency, fit.frequency),
          .tension = compare(bands.tension, fit.tension)};
}

}  // namespace strandyn::analysis
