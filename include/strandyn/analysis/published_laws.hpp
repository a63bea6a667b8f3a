#pragma once
/// \file The exponents of P = k A^l f^m/T^n as published, and how a fit stands to them.                   [EPRI2009]
///
/// A [m] antinode amplitude, half of peak to peak; f [Hz]; T [kN]. The laws differ among themselves by 3 to 50 times in
/// P: their band is what a result is held against, no single one of them.

#include <optional>
#include <span>
#include <string_view>

#include "strandyn/analysis/power_law.hpp"

namespace strandyn::analysis {

/// As published: one value (low = high) or a range.
struct PublishedLaw {
  std::string_view name;
  Interval amplitude;                 ///< l
  Interval frequency;                 ///< m
  std::optional<Interval> tension{};  ///< n; nothing where tension was not varied
  bool takes_common_factor = false;   ///< the factor below was meant for these exponents
  bool takes_similarity = false;      ///< its factor is the one by similarity
};
std::span<const PublishedLaw> published_laws();
inline constexpr std::string_view published_laws_source = "EPRI 2009";

/// What the common factor is made of.
struct RatedConductor {
  double diameter = 0;         ///< [m]
  double mass_per_length = 0;  ///< [kg/m]
  double rated_strength = 0;   ///< [N]
};
/// k = d/sqrt(m RTS), d in mm, m in kg/m, RTS in kN. It was meant for conductors of about 30 mm.
double common_factor(const RatedConductor& conductor);
/// k of Noiseux's exponents by his similarity: what is lost goes with d^4/lambda^5.52, lambda = sqrt(T/m)/f, so with
/// d^4 m^2.76 at a given f and T. The law gives no level of its own: it is that of the common factor for the conductor
/// of 31.68 mm, 1.981 kg/m and 162.8 kN (Curlew). D. U. Noiseux, "Similarity laws of the internal damping of stranded
/// cables in transverse vibrations", IEEE Transactions on Power Delivery 7 (1992).
double similarity_factor(const RatedConductor& conductor);
/// Exponents and factor; nothing for a law that has no factor.
std::optional<PowerLaw> law_for(const PublishedLaw& published, const RatedConductor& conductor);

/// From the smallest published value to the largest.
struct ExponentBands {
  Interval amplitude, frequency, tension;
};
ExponentBands published_bands();

/// How far a value is outside of a band: 0 inside, below zero under its low end, above zero over its high end.
double outside(const Interval& band, double value);

/// Per exponent `outside` of the published band; nothing where the fit has no such exponent.
struct BandComparison {
  std::optional<double> amplitude, frequency, tension;
};
BandComparison compare_with_published(const PowerLawFit& fit);

}  // namespace strandyn::analysis
