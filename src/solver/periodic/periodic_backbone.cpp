// Resonances from one amplitude to the next.

#include <cmath>

#include "strandyn/solver/periodic/periodic.hpp"

namespace strandyn::solver {

using Eigen::Index;

namespace {

/// How often a step of a backbone is halved.
constexpr int most_halvings = 4;

/// Where a line through two solutions is at another amplitude.
PeriodicState extrapolated(const PeriodicSolution& before, const PeriodicSolution& last, double amplitude) {
  const double t = (amplitude - last.amplitude) / (last.amplitude - before.amplitude);
  PeriodicState state = last.state;
  state.harmonics += t * (last.state.harmonics - before.state.harmonics);
  state.frequency += t * (last.state.frequency - before.state.frequency);
  state.drive += t * (last.state.drive - before.state.drive);
  return state;
}

}  // namespace

std::vector<PeriodicSolution> PeriodicSolver::backbone(const std::vector<double>& amplitudes, const Mode& mode) const {
  std::vector<PeriodicSolution> solutions;
  for (const double amplitude : amplitudes) {
    if (solutions.empty()) {
      solutions.push_back(resonance(amplitude, from_mode(mode, amplitude)));
    } else {
      const PeriodicSolution& last = solutions.back();
      const PeriodicSolution* before = solutions.size() > 1 ? &solutions[solutions.size() - 2] : nullptr;
      PeriodicSolution next;
      if (before) next = resonance(amplitude, extrapolated(*before, last, amplitude));
      if (!next.converged) {
        const section::Effort spent = next.effort;
        next = follow(last, amplitude, most_halvings);
        next.effort += spent;
      }
      solutions.push_back(std::move(next));
    }
    if (!solutions.back().converged) break;
  }
  return solutions;
}

PeriodicSolution PeriodicSolver::follow(const PeriodicSolution& from, double amplitude, int halvings) const {
  PeriodicState start = from.state;
  // Tension and all that is of second degree grows with the square.
  const double growth = amplitude / from.amplitude;
  for (Index a = 0; a < start.harmonics.cols(); ++a) {
    start.harmonics.col(a) *= (a + 1) / 2 % 2 == 1 ? growth : growth * growth;
  }
  PeriodicSolution solution = resonance(amplitude, start);
  if (solution.converged || halvings == 0) return solution;
  const section::Effort spent = solution.effort;
  const PeriodicSolution middle = follow(from, std::sqrt(amplitude * from.amplitude), halvings - 1);
  if (middle.converged) solution = follow(middle, amplitude, halvings - 1);
  solution.effort += spent;
  solution.effort += middle.effort;
  return solution;
}

}  // namespace strandyn::solver
