#include "periodic_loop.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::solver {

using section::Component;
using section::Field;

namespace {

/// Largest change from one field to the other, forces relative to the largest force in `all`, moments to the largest
/// moment.
void find_gap(const Field& before, const std::vector<Field>& all, SectionLoops& loops) {
  double force = 0;
  double moment = 0;
  for (const Field& field : all) {
    for (std::size_t c = 0; c < section::component_count; ++c) {
      double& largest = Component{c} == Component::axial ? force : moment;
      for (const double value : field[Component{c}]) largest = std::max(largest, std::abs(value));
    }
  }
  loops.gap = 0;
  for (std::size_t c = 0; c < section::component_count; ++c) {
    const auto& was = before[Component{c}];
    const auto& is = all.front()[Component{c}];
    const double largest = Component{c} == Component::axial ? force : moment;
    for (std::size_t p = 0; p < std::min(before.points(), was.size()); ++p) {
      if (std::abs(is[p] - was[p]) <= loops.gap * largest) continue;
      loops.gap = std::abs(is[p] - was[p]) / largest;
      loops.worst = p;
    }
  }
}

}  // namespace

SectionLoops lead_around(const section::Law& law, const section::History& rest, const std::vector<Field>& strains,
                         const LoopOptions& options) {
  const std::size_t samples = strains.size();
  const std::size_t points = strains.front().points();
  SectionLoops loops{.stresses = strains, .friction = {}, .quadrature_error = {}};
  section::History history = rest;
  section::StepEnergy energy(points);
  for (std::size_t j = 1; j <= samples; ++j) {
    end_if_asked(options.stop);
    loops.effort += law.commit(history, strains[j % samples], energy);
  }
  Field before = strains.front();
  loops.effort += law.respond(history, strains.front(), before, nullptr);
  for (loops.cycles = 2;; ++loops.cycles) {
    loops.friction.assign(points, 0.0);
    loops.quadrature_error.assign(points, 0.0);
    for (std::size_t j = 1; j <= samples; ++j) {
      end_if_asked(options.stop);
      const Field& strain = strains[j % samples];
      loops.effort += law.commit(history, strain, energy);
      loops.effort += law.respond(history, strain, loops.stresses[j % samples], nullptr);
      for (std::size_t p = 0; p < points; ++p) {
        loops.friction[p] += energy.dissipated[p];
        loops.quadrature_error[p] += energy.quadrature_error[p];
      }
    }
    find_gap(before, loops.stresses, loops);
    if (loops.gap <= options.closure || loops.cycles >= options.max_cycles) break;
    before = loops.stresses.front();
  }
  return loops;
}

}  // namespace strandyn::solver
