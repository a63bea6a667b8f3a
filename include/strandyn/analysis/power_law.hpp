#pragma once
/// \file The power law of self-damping that everyone quotes, fitted by linear least squares in logarithms.
///
///     P = k A^l f^m/T^n,   ln P = ln k + l ln A + m ln f - n ln T                                  [EPRI2009]
/// P [W/m], A [m] the antinode amplitude, half of peak to peak, f [Hz], T in kN as in the published sets (inputs are in
/// newtons, k is not SI). Standard errors from the residuals, intervals of 95 % by Student's t.
///
/// What the points cannot determine is absent: the exponent of a variable that does not vary, the exponents of two that
/// vary together (one mode at many tensions: f ~ sqrt(T)). Points without loss cannot be fitted; they are counted.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace strandyn::analysis {

struct TestCondition {
  double antinode_amplitude = 0;  ///< [m]
  double frequency = 0;           ///< [Hz]
  double tension = 0;             ///< [N]
};
struct SelfDampingPoint {
  TestCondition at;
  double power = 0;  ///< [W/m]
};

struct PowerLaw {
  double factor = 0;     ///< k, for A in m, f in Hz, T in kN, P in W/m
  double amplitude = 0;  ///< l [-]
  double frequency = 0;  ///< m [-]
  double tension = 0;    ///< n [-]
};
double power(const PowerLaw& law, const TestCondition& at);  ///< [W/m]

struct Interval {
  double low = 0, high = 0;
};
struct Estimate {
  double value = 0;
  std::optional<double> standard_error{};  ///< nothing where there are no more points than parameters
  std::optional<Interval> interval_95{};
};

/// Both ends belong to the band.
struct AmplitudeBand {
  double lowest = 0;                                         ///< [m]
  double highest = std::numeric_limits<double>::infinity();  ///< [m]
};

struct PowerLawFit {
  std::optional<Estimate> amplitude;  ///< l
  std::optional<Estimate> frequency;  ///< m
  std::optional<Estimate> tension;    ///< n
  /// ln k. The absent exponents count as zero, so k holds at the one tension (or frequency, amplitude) of the points;
  /// nothing where an absent exponent belongs to a variable that varies.
  std::optional<Estimate> log_factor;
  std::optional<double> r_squared;      ///< [-] of ln P; nothing where all P are alike
  double scatter = 0;                   ///< [-] rms residual of ln P
  std::size_t points = 0;               ///< that were fitted
  std::size_t without_loss = 0;         ///< in the band with P <= 0: not fitted
  std::size_t unusable = 0;             ///< in the band, with a value that is not finite, or no f or T above zero
  std::optional<double> no_slip_below;  ///< [m] the largest A up to which no point of the band loses anything

  std::optional<PowerLaw> law() const;  ///< nothing without a factor, or with one beyond what a number can hold
};

/// A variable whose values lie within 1 % counts as constant.
PowerLawFit fit_power_law(std::span<const SelfDampingPoint> points, const AmplitudeBand& band = {});

/// t > 0 such that a Student variable of `degrees` (1, 2, ...) of freedom lies within +-t with probability `confidence`
/// (0 to 1, ends excluded).  [AS1964, 26.7.3, 26.7.4]
double student_t(int degrees, double confidence);

}  // namespace strandyn::analysis
