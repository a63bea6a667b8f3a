#include "reference_beam.hpp"

#include <cmath>
#include <numbers>

#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::bench {

using section::Component;

Span::Span(const std::string& name, const std::vector<std::string>& overrides)
    : scene(casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/" + name, overrides)),
      built(build::build_span(scene)),
      system(built.model),
      u(system.make_vector()) {
  if (built.hanging.size() > 0) {
    u = solver::find_rest(system, {.guess = built.hanging, .straight = built.straight});
  } else {
    system.begin(u);
  }
}

system::Vector sine_velocity(const Span& span, int loops, double antinode_velocity) {
  const model::Model& model = span.built.model;
  system::Vector v = span.system.make_vector();
  const double wave_number = loops * std::numbers::pi / span.built.length;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const double phase = wave_number * model.nodes[node].x();
    const auto set = [&](model::Unknown unknown, double value) {
      const std::size_t i = *model.index(node, unknown);
      if (!span.system.is_held(i)) v(static_cast<Eigen::Index>(i)) = value;
    };
    set(model::Unknown::y, antinode_velocity * std::sin(phase));
    set(model::Unknown::rotation_z, antinode_velocity * wave_number * std::cos(phase));
  }
  return v;
}

solver::IntegratorSummary integrate(Span& span, const system::Vector& velocity, double step, std::size_t steps,
                                    std::span<observe::Observer* const> observers) {
  const casefile::Integrator& chosen = span.scene.integrator;
  const solver::InitialMotion initial{.u = span.u, .v = velocity};
  std::vector<model::Drive> drives;  // of frequencies that are given; those of modes rest
  for (const build::DriveAsk& ask : span.built.drives) drives.push_back({.frequency = ask.frequency.value_or(0)});
  const solver::IntegratorOptions options{.step = step,
                                          .end_time = step * static_cast<double>(steps),
                                          .newton_tolerance = chosen.newton_tolerance,
                                          .stop = {},
                                          .drives = drives};
  if (chosen.method == casefile::Method::ida) {
    return solver::integrate(span.system, initial, options, solver::Ida{}, observers);
  }
  return solver::integrate(span.system, initial, options, solver::GeneralizedAlpha{.rho_inf = chosen.rho_inf},
                           observers);
}

void BendingWork::begin(const system::System& system, const observe::StepRecord& initial) {
  force_ = system.make_vector();
  system.internal_force(initial.u.data(), force_.data());
  curvatures_ = system.committed_strains();
  moments_ = system.last_stresses();
}

void BendingWork::step(const system::System& system, const observe::StepRecord& record) {
  system.internal_force(record.u.data(), force_.data());
  const section::Field& curvatures = system.committed_strains();
  const section::Field& moments = system.last_stresses();
  for (Component axis : {Component::bending2, Component::bending3}) {
    if (curvatures[axis].empty()) continue;
    for (std::size_t point = 0; point < curvatures.points(); ++point) {
      work_ += system.point_length(point) * 0.5 * (moments_[axis][point] + moments[axis][point]) *
               (curvatures[axis][point] - curvatures_[axis][point]);
    }
  }
  curvatures_ = curvatures;
  moments_ = moments;
}

}  // namespace strandyn::bench
