#include "strandyn/exact/catenary.hpp"

#include <cmath>

#include "bisect.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {
namespace {

// u with sinh(u)/u = ratio > 1. The mean of cosh over (0, u) exceeds cosh(u/2) > e^(u/2)/2: a bound of u from above.
double inverse_sinhc(double ratio) {
  return bisect({.positive = 0, .negative = 2 * std::log(2 * ratio) + 2},
                [ratio](double u) { return ratio - std::sinh(u) / u; });
}

}  // namespace

Catenary::Catenary(const CatenarySpan& span, double a) : span_(span), a_(a) {
  midslope_ = std::asinh(span.height_difference / (2 * a * std::sinh(span.span / (2 * a))));
}

Catenary Catenary::from_horizontal_tension(const CatenarySpan& span, double horizontal_tension) {
  STRANDYN_ASSERT(horizontal_tension > 0 && span.weight_per_length > 0 && span.span > 0, horizontal_tension);
  return {span, horizontal_tension / span.weight_per_length};
}

Catenary Catenary::from_length(const CatenarySpan& span, double length) {
  STRANDYN_ASSERT(length > std::hypot(span.span, span.height_difference), length);
  const double h = span.height_difference;
  const double u = inverse_sinhc(std::sqrt((length - h) * (length + h)) / span.span);
  return {span, span.span / (2 * u)};
}

double Catenary::horizontal_tension() const {
  return span_.weight_per_length * a_;
}

double Catenary::length() const {
  return std::hypot(2 * a_ * std::sinh(span_.span / (2 * a_)), span_.height_difference);
}

double Catenary::sag() const {
  const double quarter = std::sinh(span_.span / (4 * a_));
  return 2 * a_ * std::cosh(midslope_) * quarter * quarter;
}

double Catenary::height(double x) const {
  // a [cosh v - cosh u] = 2 a sinh((v + u)/2) sinh((v - u)/2), v at x and u at the left support.
  return 2 * a_ * std::sinh(midslope_ + (x - span_.span) / (2 * a_)) * std::sinh(x / (2 * a_));
}

double Catenary::slope(double x) const {
  return std::sinh(midslope_ + (x - span_.span / 2) / a_);
}

double Catenary::tension(double x) const {
  return horizontal_tension() * std::cosh(midslope_ + (x - span_.span / 2) / a_);
}

}  // namespace strandyn::exact
