#include "strandyn/damper/bending_loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::damper {

using section::Component;

BendingLoops::BendingLoops(const section::Law& law, const BendingLoopOptions& o) : options_(o) {
  const double decades = std::log10(o.largest / o.smallest);
  const auto points = static_cast<std::size_t>(std::ceil(decades * o.per_decade)) + 1;
  std::vector<double> amplitude;
  for (std::size_t i = 0; i < points; ++i) {
    amplitude.push_back(o.smallest * std::pow(10.0, static_cast<double>(i) / o.per_decade));
  }
  section::Field strains(section::Dimension::planar, points);
  section::Field stresses = strains;
  section::History history = law.start(strains);
  section::StepEnergy energy(points);
  stiffness_.assign(points, 0);
  for (int step = 1; step <= o.cycles * o.samples; ++step) {
    const double angle = 2 * std::numbers::pi * step / o.samples;
    for (std::size_t i = 0; i < points; ++i) strains[Component::bending2][i] = amplitude[i] * std::cos(angle);
    effort_ += law.commit(history, strains, energy);
    if (step <= (o.cycles - 1) * o.samples) continue;
    effort_ += law.respond(history, strains, stresses, nullptr);
    const std::complex<double> weight = 2.0 / o.samples * std::polar(1.0, -angle);
    for (std::size_t i = 0; i < points; ++i) {
      stiffness_[i] += weight * stresses[Component::bending2][i] / amplitude[i];
    }
  }
}

std::complex<double> BendingLoops::stiffness(double amplitude) const {
  const double last = static_cast<double>(stiffness_.size() - 1);
  const double at =
      amplitude <= options_.smallest ? 0 : std::log10(amplitude / options_.smallest) * options_.per_decade;
  const double place = std::clamp(at, 0.0, last);
  const auto below = std::min(static_cast<std::size_t>(place), stiffness_.size() - 2);
  const double part = place - static_cast<double>(below);
  return (1 - part) * stiffness_[below] + part * stiffness_[below + 1];
}

}  // namespace strandyn::damper
