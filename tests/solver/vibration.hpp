#pragma once
/// \file A span at rest and one of its modes, for tests that set it in motion.

#include <numbers>

#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "system/spans.hpp"

namespace strandyn::test {

class Vibration {
 public:
  Vibration(LawPointer law, const SpanOptions& options, std::size_t mode_number)
      : model(curlew_span(std::move(law), options)), system(model), rest(zeros(model)) {
    system.begin(rest);
    mode = solver::transverse_modes(system, rest, mode_number).back();
  }
  Vibration(const Vibration&) = delete;
  Vibration& operator=(const Vibration&) = delete;

  double period() const { return 1 / mode.frequency; }
  double omega() const { return 2 * std::numbers::pi * mode.frequency; }

  /// From rest in the shape of the mode, so that the antinode will swing by `amplitude` [m].
  solver::InitialMotion start(double amplitude) const { return {.u = rest, .v = amplitude * omega() * mode.shape}; }

  solver::IntegratorOptions options(double steps_per_cycle, double cycles) const {
    return {.step = period() / steps_per_cycle, .end_time = cycles * period(), .stop = {}};
  }

  /// The mode's share in a motion. [m]
  double coordinate(const system::Vector& u) const {
    system::Matrix M = system.make_matrix();
    system.mass_matrix(rest.data(), M);
    system::Vector product(u.size());
    M.multiply(u.data(), product.data());
    return mode.shape.dot(product) / mode.modal_mass;
  }

  model::Model model;
  system::System system;
  system::Vector rest;
  solver::Mode mode;
};

}  // namespace strandyn::test
