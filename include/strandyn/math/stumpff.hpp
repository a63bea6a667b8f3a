#pragma once
/// \file Stumpff's functions: what a rotation vector psi needs instead of sines and cosines of its length.
///
///     c_k(s) = sum_i (-s)^i/(2i + k)!,      s = |psi|^2 >= 0:      c_0 = cos|psi|,   c_1 = sin|psi|/|psi|,   ...
///     c_k = 1/k! - s c_{k+2},               c_k' = (k c_{k+2} - c_{k+1})/2
/// They are entire, so nothing special happens at psi = 0, and derivatives stay among them:
///     Exp(psi) a = c_0 a + c_1 psi x a + c_2 (psi . a) psi,      T(psi) a = c_1 a + c_2 psi x a + c_3 (psi . a) psi

#include <array>
#include <cmath>
#include <cstddef>

namespace strandyn::math {

/// c_0 to c_7 at one s. Up to c_3 they make the rotation and its spin map; two time derivatives of the map need c_7.
using Stumpff = std::array<double, 8>;

namespace detail {

inline constexpr std::size_t stumpff_terms = 12;  ///< of the series below its limit: the first left out is 1e-18 of c_k
inline constexpr double stumpff_series_limit = 9;  ///< [-] of s, that is |psi| < 3

/// (-1)^i/(2i + k)!, i = 0 .. 11.
constexpr std::array<double, stumpff_terms> stumpff_series(std::size_t k) {
  std::array<double, stumpff_terms> coefficient{};
  double value = 1;
  for (std::size_t j = 2; j <= k; ++j) value /= static_cast<double>(j);
  for (std::size_t i = 0; i < stumpff_terms; ++i) {
    coefficient[i] = value;
    value /= -static_cast<double>((2 * i + k + 1) * (2 * i + k + 2));
  }
  return coefficient;
}

inline constexpr std::array<double, 6> reciprocal_factorial = {1, 1, 1. / 2, 1. / 6, 1. / 24, 1. / 120};

}  // namespace detail

/// The error is below 2e-15 of 1/k!. Below |psi| = 3 the two highest come from their series, where nothing cancels, and
/// the others from c_k = 1/k! - s c_{k+2}, which does not blow errors up in this direction; above, the other way round.
inline Stumpff stumpff(double s) {
  constexpr auto series6 = detail::stumpff_series(6);
  constexpr auto series7 = detail::stumpff_series(7);
  Stumpff c;
  if (s < detail::stumpff_series_limit) {
    c[6] = c[7] = 0;
    for (std::size_t i = detail::stumpff_terms; i-- > 0;) {
      c[6] = c[6] * s + series6[i];
      c[7] = c[7] * s + series7[i];
    }
    for (std::size_t k = 6; k-- > 0;) c[k] = detail::reciprocal_factorial[k] - s * c[k + 2];
  } else {
    const double angle = std::sqrt(s);
    const double sine = std::sin(angle / 2);  // of the half angle: 1 - cos loses digits near whole turns
    const double cosine = std::cos(angle / 2);
    c[0] = (cosine - sine) * (cosine + sine);
    c[1] = 2 * sine * cosine / angle;
    c[2] = 2 * sine * sine / s;
    for (std::size_t k = 1; k < 6; ++k) c[k + 2] = (detail::reciprocal_factorial[k] - c[k]) / s;
  }
  return c;
}

/// dc_k/ds, k = 0 .. 5.
inline double stumpff_derivative(const Stumpff& c, std::size_t k) {
  return (static_cast<double>(k) * c[k + 2] - c[k + 1]) / 2;
}

/// d^2c_k/ds^2, k = 0 .. 3.
inline double stumpff_second_derivative(const Stumpff& c, std::size_t k) {
  return (static_cast<double>(k) * stumpff_derivative(c, k + 2) - stumpff_derivative(c, k + 1)) / 2;
}

}  // namespace strandyn::math
