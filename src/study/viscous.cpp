#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace strandyn::study {

using casefile::Scene;
using system::Vector;

/// Modal and Rayleigh damping about the state of rest.
void set_proportional_damping(const Scene& scene, SpanAtRest& span) {
  system::System& system = span.system;
  system::ProportionalDamping damping;
  system::Matrix M = system.make_matrix();
  system.mass_matrix(span.u.data(), M);
  if (const auto& rayleigh = scene.damping.rayleigh; rayleigh && (rayleigh->mass > 0 || rayleigh->stiffness > 0)) {
    for (std::size_t i = 0; i < system.unknowns() && rayleigh->stiffness > 0; ++i) {
      if (system.is_held(i) || system.has_mass(i)) continue;
      refuse(scene.source, "damping.rayleigh",
             "rotations without inertia have no velocity that stiffness damping could act on",
             "give [span] mass = \"consistent\", or rotary_inertia = true");
    }
    system::Matrix C = system.make_matrix();
    Vector force = system.make_vector();
    system.internal_force(span.u.data(), force.data(), C);
    C.make_symmetric();
    system::Matrix sum = system.make_matrix();
    sum.add(rayleigh->stiffness, C);
    sum.add(rayleigh->mass, M);
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (system.is_held(i)) sum.pin(i, 0);
    }
    damping.rayleigh = sum;
  }
  if (!scene.damping.modal.empty()) {
    double highest = 0;
    for (const auto& [mode, ratio] : scene.damping.modal) highest = std::max(highest, mode);
    const auto modes = solver::transverse_modes(system, span.u, static_cast<std::size_t>(highest));
    for (const auto& [number, ratio] : scene.damping.modal) {
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

}  // namespace strandyn::study
