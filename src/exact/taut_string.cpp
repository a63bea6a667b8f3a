#include "strandyn/exact/taut_string.hpp"

#include <cmath>
#include <numbers>

#include "bisect.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {

double wave_speed(const TautString& string) {
  return std::sqrt(string.tension / string.mass_per_length);
}

double frequency(const TautString& string, int n) {
  return n * wave_speed(string) / (2 * string.length);
}

double irvine_parameter(const SaggedCable& cable) {
  const double weight_ratio = cable.weight_per_length * cable.length / cable.horizontal_tension;
  const double elastic_length_ratio = 1 + weight_ratio * weight_ratio / 8;
  return weight_ratio * weight_ratio * cable.EA / (cable.horizontal_tension * elastic_length_ratio);
}

double first_symmetric_ratio(double lambda_squared) {
  STRANDYN_ASSERT(lambda_squared >= 0, lambda_squared);
  constexpr double pi = std::numbers::pi;
  if (lambda_squared == 0) return 1;
  // Times cos v: finite everywhere, 1 at pi/2 and -1 at 3 pi/2.
  const double v = bisect({.positive = pi / 2, .negative = 3 * pi / 2}, [lambda_squared](double x) {
    return std::sin(x) - (x - 4 * x * x * x / lambda_squared) * std::cos(x);
  });
  return 2 * v / pi;
}

}  // namespace strandyn::exact
