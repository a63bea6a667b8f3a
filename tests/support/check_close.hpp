#pragma once
/// \file The comparison of this house: relative to the expected value or absolute, never a mixture, and it prints
/// digits.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace strandyn::test {

/// How far a value may be from the expected one: relative to |expected|, or absolute in the value's unit.
struct Within {
  double relative = 0;
  double absolute = 0;
};

/// Correct decimal digits of `got` against `expected` (17 where they are equal).
inline double correct_digits(double got, double expected) {
  if (got == expected) return 17;
  const double scale = expected != 0 ? std::abs(expected) : 1.0;
  return -std::log10(std::abs(got - expected) / scale);
}

/// Fails, with both values and the digits that agree, unless |got - expected| <= absolute + relative |expected|.
inline void check_close(double got, double expected, Within within, const std::string& what = {}) {
  const double allowed = within.absolute + within.relative * std::abs(expected);
  const std::string report =
      fmt::format("{} got {:.12g}, expected {:.12g}: {:.1f} digits, off by {:.3g}, allowed {:.3g}", what, got, expected,
                  correct_digits(got, expected), std::abs(got - expected), allowed);
  CHECK_MESSAGE(std::abs(got - expected) <= allowed, report);
}

}  // namespace strandyn::test
