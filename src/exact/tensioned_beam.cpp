#include "strandyn/exact/tensioned_beam.hpp"

#include <cmath>
#include <numbers>

#include "bisect.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {
namespace {

constexpr double pi = std::numbers::pi;

// cosh(p z)/cosh(p/2) and sinh(p z)/sinh(p/2) for |z| <= 1/2: 1 at the right end, never large.
double cosh_ratio(double p, double z) {
  const double y = std::abs(z);
  return std::exp(-p * (0.5 - y)) * (1 + std::exp(-2 * p * y)) / (1 + std::exp(-p));
}

double sinh_ratio(double p, double z) {
  const double y = std::abs(z);
  return std::copysign(std::exp(-p * (0.5 - y)) * std::expm1(-2 * p * y) / std::expm1(-p), z);
}

// Trigonometric wavenumber times L of clamped mode n. The equation, over cosh p, is -+ 2 p r (...) at both ends of
// (n pi, (n + 1) pi), of opposite sign.
double clamped_root(double xi, int n) {
  const auto equation = [xi](double r) {
    const double p = std::hypot(xi, r);
    return 2 * p * r * (1 / std::cosh(p) - std::cos(r)) + xi * xi * std::tanh(p) * std::sin(r);
  };
  const double left = n * pi;
  const double right = (n + 1) * pi;
  return n % 2 == 1 ? bisect({.positive = left, .negative = right}, equation)
                    : bisect({.positive = right, .negative = left}, equation);
}

}  // namespace

TensionedBeamMode::TensionedBeamMode(const TensionedBeam& beam, BeamEnds ends, int n)
    : n_(n), ends_(ends), length_(beam.length) {
  STRANDYN_ASSERT(beam.EI > 0 && beam.tension >= 0 && beam.mass_per_length > 0 && beam.length > 0, beam.EI);
  STRANDYN_ASSERT(n >= 1, n);
  const double L = beam.length;
  const double xi = L * std::sqrt(beam.tension / beam.EI);
  r_ = ends == BeamEnds::pinned ? n * pi : clamped_root(xi, n);
  p_ = std::hypot(xi, r_);
  frequency_ = p_ * r_ * std::sqrt(beam.EI / beam.mass_per_length) / (L * L) / (2 * pi);
  if (ends == BeamEnds::pinned) return;

  // The antinode next to the clamp is the largest: the end takes a lag phi = atan(r/p) out of the wave, so it lies
  // where r x is between phi and phi + pi/2. A single antinode lies at midspan.
  const double phi = std::atan2(r_, p_);
  const auto slope = [this](double s) { return unscaled(s - 0.5).slope; };
  const double rising = phi / r_;
  const double falling = (phi + pi / 2) / r_;
  const bool upright = unscaled(rising - 0.5).slope > 0;
  const double antinode = n == 1 ? 0.5 : bisect({.positive = rising, .negative = falling}, [&](double s) {
    return upright ? slope(s) : -slope(s);
  });
  scale_ = 1 / unscaled(antinode - 0.5).value;
}

// Over the span z = -1/2 .. 1/2, derivatives with respect to x. Even and odd modes apart: no cancellation of growing
// exponentials, and both clamp conditions hold at once.
ShapeAt TensionedBeamMode::unscaled(double z) const {
  const bool even = n_ % 2 == 1;
  const double wave = even ? std::cos(r_ * z) : std::sin(r_ * z);
  const double wave_slope = r_ * (even ? -std::sin(r_ * z) : std::cos(r_ * z));
  const double end = even ? std::cos(r_ / 2) : std::sin(r_ / 2);
  const double edge = even ? cosh_ratio(p_, z) : sinh_ratio(p_, z);
  const double tanh_half = std::tanh(p_ / 2);
  const double edge_slope = p_ * (even ? tanh_half * sinh_ratio(p_, z) : cosh_ratio(p_, z) / tanh_half);
  return {.value = wave - end * edge,
          .slope = (wave_slope - end * edge_slope) / length_,
          .curvature = (-r_ * r_ * wave - p_ * p_ * end * edge) / (length_ * length_)};
}

ShapeAt TensionedBeamMode::at(double x) const {
  STRANDYN_ASSERT(x >= 0 && x <= length_, x);
  if (ends_ == BeamEnds::pinned) {
    const double k = r_ / length_;
    return {.value = std::sin(k * x), .slope = k * std::cos(k * x), .curvature = -k * k * std::sin(k * x)};
  }
  const ShapeAt w = unscaled(x / length_ - 0.5);
  return {.value = scale_ * w.value, .slope = scale_ * w.slope, .curvature = scale_ * w.curvature};
}

}  // namespace strandyn::exact
