#include "strandyn/damper/arm_chain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "arm_model.hpp"
#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/system/system.hpp"
#include "without_axial.hpp"

namespace strandyn::damper {

using solver::PeriodicSolution;

namespace {

/// A step from one answer to the next is halved so often.
constexpr int most_halvings = 5;
/// From rest, amplitude is raised in so many doublings.
constexpr int doublings = 6;

/// Between two motions of the clamp, evenly in logarithms.
Shake between(const Shake& a, const Shake& b) {
  return {.frequency = std::sqrt(a.frequency * b.frequency), .velocity = std::sqrt(a.velocity * b.velocity)};
}

}  // namespace

ArmChain::ArmChain(const Arm& arm, const Messenger& messenger, const ArmChainOptions& options)
    : arm_(arm), messenger_(messenger), options_(options) {
  messenger_.law = std::make_shared<WithoutAxial>(messenger.law);
}

std::size_t ArmChain::section_points() const {
  return options_.elements * beam::gauss_points;
}

model::Model ArmChain::model_at(double frequency) const {
  return arm_model(arm_, messenger_, options_.elements, frequency);
}

std::vector<double> ArmChain::natural_frequencies(std::size_t count) const {
  const model::Model model = model_at(0);
  system::System system(model);
  const system::Vector rest = system.make_vector();
  system.begin(rest);
  std::vector<double> frequencies;
  for (const solver::Mode& mode : solver::transverse_modes(system, rest, count, options_.stop)) {
    frequencies.push_back(mode.frequency);
  }
  return frequencies;
}

PeriodicSolution ArmChain::solve(const Shake& shake, const Reached* from, section::Effort& effort) const {
  const model::Model model = model_at(shake.frequency);
  system::System system(model);
  const system::Vector rest = system.make_vector();
  system.begin(rest);
  const solver::PeriodicSolver solver(
      system, rest, {.kind = solver::DriveKind::motion, .drive = {.node = 0}, .control = {.node = options_.elements}},
      {.harmonics = options_.harmonics, .samples = options_.samples, .stop = options_.stop});
  solver::PeriodicState start = solver.from_rest(shake.frequency, shake.displacement());
  if (from) {
    start.harmonics = from->solution.state.harmonics * (shake.displacement() / from->shake.displacement());
  }
  PeriodicSolution solution = solver.forced(shake.frequency, shake.displacement(), start);
  effort += solution.effort;
  return solution;
}

PeriodicSolution ArmChain::walk(const Reached& from, const Shake& to, int halvings, section::Effort& effort) const {
  PeriodicSolution solution = solve(to, &from, effort);
  if (solution.converged || halvings == 0) return solution;
  const Shake half = between(from.shake, to);
  const PeriodicSolution middle = walk(from, half, halvings - 1, effort);
  return middle.converged ? walk({.shake = half, .solution = middle}, to, halvings - 1, effort) : solution;
}

ArmAnswer ArmChain::answer_of(const Shake& shake, const PeriodicSolution& solution) const {
  // The solver counts from the displacement; here the velocity is real: i w exp(i w t).
  const Complex ahead{0, 1};
  const std::size_t last = options_.elements * 2;
  ArmAnswer answer{.converged = solution.converged, .failure = solution.failure, .shake = shake};
  answer.force = solution.drive_force / ahead;
  answer.tip = solution.state.phasor(last) / ahead;
  answer.turn = solution.state.phasor(last + 1) / ahead;
  answer.friction = solution.friction;
  answer.material = solution.material;
  // Linear over the first element, from its two points to the clamp.
  const auto& chi = solution.sections.curvature_amplitude;
  answer.clamp_curvature = chi[0] + (chi[0] - chi[1]) * (std::sqrt(3) - 1) / 2;
  return answer;
}

ArmAnswer ArmChain::answer(const Shake& shake) {
  section::Effort effort;
  PeriodicSolution solution = last_ ? walk(*last_, shake, most_halvings, effort) : solve(shake, nullptr, effort);
  if (!solution.converged) {
    // From an amplitude so small that little slips.
    Shake low = shake;
    low.velocity *= std::pow(0.5, doublings);
    const PeriodicSolution small = solve(low, nullptr, effort);
    if (small.converged) solution = walk({.shake = low, .solution = small}, shake, most_halvings + 1, effort);
  }
  ArmAnswer answer = answer_of(shake, solution);
  answer.effort = effort;
  last_.reset();
  if (solution.converged) last_ = Reached{.shake = shake, .solution = std::move(solution)};
  return answer;
}

}  // namespace strandyn::damper
