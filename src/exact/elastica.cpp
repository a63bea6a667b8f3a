#include "strandyn/exact/elastica.hpp"

#include <algorithm>
#include <cmath>

#include "bisect.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {
namespace {

// Carlson's symmetric integrals by duplication [Carlson1979]: unlike F(psi, k) of the standard library they take the
// complements cos^2(psi) and 1 - k^2 sin^2(psi), which are tiny for large loads.
struct Carlson {
  double x = 0;
  double y = 0;
  double z = 0;
};

Carlson duplicate(const Carlson& at, double lambda) {
  return {.x = (at.x + lambda) / 4, .y = (at.y + lambda) / 4, .z = (at.z + lambda) / 4};
}

double lambda_of(const Carlson& at) {
  return std::sqrt(at.x) * std::sqrt(at.y) + (std::sqrt(at.x) + std::sqrt(at.y)) * std::sqrt(at.z);
}

// The series is cut after the fifth order of these deviations, so 1e-3 leaves 1e-18.
double largest(double a, double b, double c) {
  return std::max({std::abs(a), std::abs(b), std::abs(c)});
}

double R_F(Carlson at) {
  while (true) {
    const double mean = (at.x + at.y + at.z) / 3;
    const double X = 1 - at.x / mean;
    const double Y = 1 - at.y / mean;
    const double Z = -X - Y;
    if (largest(X, Y, Z) < 1e-3) {
      const double e2 = X * Y - Z * Z;
      const double e3 = X * Y * Z;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
    }
    at = duplicate(at, lambda_of(at));
  }
}

double R_D(Carlson at) {
  double sum = 0;
  double power = 1;
  while (true) {
    const double mean = (at.x + at.y + 3 * at.z) / 5;
    const double X = 1 - at.x / mean;
    const double Y = 1 - at.y / mean;
    const double Z = -(X + Y) / 3;
    if (largest(X, Y, Z) < 1e-3) {
      const double e2 = X * Y - 6 * Z * Z;
      const double e3 = (3 * X * Y - 8 * Z * Z) * Z;
      const double e4 = 3 * (X * Y - Z * Z) * Z * Z;
      const double e5 = X * Y * Z * Z * Z;
      const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
      return 3 * sum + power * series / (mean * std::sqrt(mean));
    }
    const double lambda = lambda_of(at);
    sum += power / (std::sqrt(at.z) * (at.z + lambda));
    power /= 4;
    at = duplicate(at, lambda);
  }
}

// Everything as a function of t = (1 - s)/(2 s), which keeps both s and 1 - s to their last digits.
struct Shape {
  double s = 0;  // sin of the tip slope
  double one_minus_s = 0;
  double F = 0;  // F(psi, k), the root of the dimensionless load
  double E = 0;  // E(psi, k)
};

Shape shape_of(double t) {
  const double s = 1 / (1 + 2 * t);
  const double k_squared = (1 + t) / (1 + 2 * t);
  const Carlson at{.x = t / (1 + t), .y = 2 * t / (1 + 2 * t), .z = 1};
  const double sin_psi = 1 / std::sqrt(1 + t);
  const double F = sin_psi * R_F(at);
  return {.s = s,
          .one_minus_s = 2 * t / (1 + 2 * t),
          .F = F,
          .E = F - k_squared * sin_psi * sin_psi * sin_psi / 3 * R_D(at)};
}

}  // namespace

CantileverTip cantilever_elastica(const CantileverLoad& load) {
  STRANDYN_ASSERT(load.force >= 0 && load.EI > 0 && load.length > 0, load.force);
  const double root = load.length * std::sqrt(load.force / load.EI);
  if (root == 0) return {};
  STRANDYN_ASSERT(root * root <= 1e5 * (1 + 1e-12), root * root);
  const double log_t =
      bisect({.positive = -700, .negative = 700}, [root](double u) { return shape_of(std::exp(u)).F - root; });
  const Shape shape = shape_of(std::exp(log_t));
  const double reach = std::sqrt(2 * shape.s) / shape.F;  // 1 + u/L
  return {.deflection = load.length * (1 + reach - 2 * shape.E / shape.F),
          .shortening = load.length * (reach - 1),
          .slope = std::atan2(shape.s, std::sqrt(shape.one_minus_s * (1 + shape.s)))};
}

}  // namespace strandyn::exact
