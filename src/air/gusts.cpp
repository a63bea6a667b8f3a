#include "strandyn/air/gusts.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace strandyn::air {

using std::numbers::pi;

Gusts::Gusts(const Turbulence& turbulence) {
  if (turbulence.intensity == 0) return;
  constexpr int count = 200;
  const double time = turbulence.length / turbulence.speed;
  const double lowest = 0.003 / time;
  const double ratio = std::log(turbulence.highest / lowest) / count;
  std::mt19937 random(turbulence.seed);  // the numbers of this generator are the same everywhere
  const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
  double variance = 0;
  for (int i = 0; i < count; ++i) {
    const double from = lowest * std::exp(ratio * i), to = lowest * std::exp(ratio * (i + 1));
    const double f = from + draw() * (to - from);
    const double spectrum = 4 * time / std::pow(1 + 70.8 * f * time * f * time, 5.0 / 6);
    sines_.push_back(
        {.amplitude = std::sqrt(2 * spectrum * (to - from)), .omega = 2 * pi * f, .phase = 2 * pi * draw()});
    variance += spectrum * (to - from);
  }
  for (Sine& sine : sines_) sine.amplitude *= turbulence.intensity / std::sqrt(variance);
}

double Gusts::at(double time) const {
  double sum = 1;
  for (const Sine& sine : sines_) sum += sine.amplitude * std::sin(sine.omega * time + sine.phase);
  return sum;
}

double Gusts::variance() const {
  double sum = 0;
  for (const Sine& sine : sines_) sum += sine.amplitude * sine.amplitude / 2;
  return sum;
}

}  // namespace strandyn::air
