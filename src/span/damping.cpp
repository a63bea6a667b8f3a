#include "strandyn/span/damping.hpp"

#include <algorithm>
#include <numbers>

#include "strandyn/solver/modes/modes.hpp"

namespace strandyn::span {

using system::Vector;

void set_proportional_damping(SpanAtRest& span) {
  const build::ProportionalDamping& asked = span.built.damping;
  system::System& system = span.system;
  system::ProportionalDamping damping;
  system::Matrix M = system.make_matrix();
  system.mass_matrix(span.u.data(), M);
  if (asked.mass > 0 || asked.stiffness > 0) {
    system::Matrix C = system.make_matrix();
    Vector force = system.make_vector();
    system.internal_force(span.u.data(), force.data(), C);
    C.make_symmetric();
    system::Matrix sum = system.make_matrix();
    sum.add(asked.stiffness, C);
    sum.add(asked.mass, M);
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (system.is_held(i)) sum.pin(i, 0);
    }
    damping.rayleigh = sum;
  }
  if (!asked.modes.empty()) {
    const int highest = std::ranges::max(asked.modes, {}, &build::ProportionalDamping::Mode::number).number;
    const auto modes = solver::transverse_modes(system, span.u, static_cast<std::size_t>(highest));
    for (const auto& [number, ratio] : asked.modes) {
      const solver::Mode& mode = modes[static_cast<std::size_t>(number) - 1];
      Vector momentum = system.make_vector();
      M.multiply(mode.shape.data(), momentum.data());
      for (std::size_t i = 0; i < system.unknowns(); ++i) {
        if (!system.has_mass(i)) momentum(static_cast<Eigen::Index>(i)) = 0;
      }
      const double omega = 2 * std::numbers::pi * mode.frequency;
      damping.modes.push_back({.momentum = momentum, .factor = 2 * ratio * omega / mode.shape.dot(momentum)});
    }
  }
  system.set_damping(std::move(damping));
}

}  // namespace strandyn::span
