#include "strandyn/solver/static/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "newton.hpp"
#include "relaxation.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using system::System;
using system::Vector;

namespace {

/// Walks along a path step by step, halving a step that does not converge.
class Walk {
 public:
  Walk(System& system, const EquilibriumOptions& options, Staging staging, const Vector& start)
      : system_(system),
        options_(options),
        stable_only_(staging.stage != Stage::live),
        newton_(system, options, std::move(staging)),
        here_{.u = start, .factor = 0} {}

  EquilibriumSummary go() {
    prepare();
    EquilibriumSummary summary;
    double step = full_step_;
    while (!arrived(summary)) {
      PathPoint trial = here_;
      const Condition condition = aim(step, trial);
      const NewtonResult result = newton_.iterate(trial, condition);
      // A chain on its way to rest is to hang, not to stand: beyond a buckling load the straight is a solution, too.
      if (!result.converged || (stable_only_ && !is_stable(system_, trial.u, 0))) {
        step /= 2;
        if (step < full_step_ * options_.smallest_step) give_up(summary, trial, result);
        continue;
      }
      accept(step, trial, result, summary);
      step = std::min(full_step_, 2 * step);
      if (options_.stop && options_.stop()) {
        summary.stopped = true;
        break;
      }
    }
    return summary;
  }

  const Vector& u() const { return here_.u; }

 private:
  double controlled(const Vector& u) const {
    return options_.point.direction.dot(system_.model().displacement(u.data(), options_.point.node));
  }

  /// The measure of progress: lambda, the controlled displacement, or an arc.
  void prepare() {
    switch (options_.control) {
      case Control::load:
        full_step_ = 1.0 / options_.steps;
        return;
      case Control::displacement:
        start_ = controlled(here_.u);
        full_step_ = 1.0 / options_.steps;
        return;
      case Control::arc_length:
        break;
    }
    full_step_ = options_.arc_step;
    if (full_step_ > 0) return;
    const auto direction = newton_.direction(here_);
    if (!direction)
      throw ComputationError("the stiffness is singular where the path begins; hold the chain by its supports");
    full_step_ = translations(system_.model(), *direction).norm() / options_.steps;
  }

  bool arrived(const EquilibriumSummary& summary) const {
    if (options_.control != Control::arc_length) return done_ >= 1 - 1e-12;
    return here_.factor >= options_.max_load_factor || summary.steps.size() >= static_cast<std::size_t>(options_.steps);
  }

  /// The condition of the next step; moves `trial` to where the search begins.
  Condition aim(double step, PathPoint& trial) {
    Condition condition{.control = options_.control};
    if (options_.control == Control::load) {
      trial.factor = options_.max_load_factor * std::min(1.0, done_ + step);
    } else if (options_.control == Control::displacement) {
      condition.point = options_.point;
      condition.point.target = start_ + std::min(1.0, done_ + step) * (options_.point.target - start_);
    } else {
      condition.base = here_.u;
      condition.arc = step;
      const auto direction = newton_.direction(here_);
      if (direction) {
        const Vector along = translations(system_.model(), *direction);
        const bool back = last_move_.size() > 0 && along.dot(last_move_) < 0;
        const double change = (back ? -1 : 1) * step / along.norm();
        trial.u += change * *direction;
        trial.factor += change;
      }
    }
    return condition;
  }

  void accept(double step, const PathPoint& trial, const NewtonResult& result, EquilibriumSummary& summary) {
    last_move_ = translations(system_.model(), trial.u - here_.u);
    here_ = trial;
    system_.commit(here_.u.data());
    if (options_.control != Control::arc_length) done_ = std::min(1.0, done_ + step);
    const AlignedVector& dissipated = system_.step_energy().dissipated;
    const auto slipping = std::count_if(dissipated.begin(), dissipated.end(), [](double loss) { return loss > 0; });
    summary.steps.push_back({.load_factor = here_.factor,
                             .iterations = result.iterations,
                             .residual = result.residual,
                             .corrections = result.corrections,
                             .sections_slipping = static_cast<std::size_t>(slipping)});
    Vector no_rates = Vector::Zero(here_.u.size());
    system_.shorten_rotations(here_.u.data(), no_rates.data());
    const double done =
        options_.control == Control::arc_length ? static_cast<double>(summary.steps.size()) / options_.steps : done_;
    if (options_.watch) options_.watch(summary.steps.back(), here_.u, done);
  }

  [[noreturn]] void give_up(const EquilibriumSummary& summary, const PathPoint& trial,
                            const NewtonResult& result) const {
    const char* remedy = options_.control == Control::load
                             ? "use more load steps ([analysis] steps), [static] control = \"displacement\" or "
                               "\"arc-length\" where the load passes a maximum, or check the supports and the tension"
                             : "use more [analysis] steps, or check the supports and the tension";
    throw ComputationError(
        fmt::format("no static equilibrium in step {} at load factor {:.6g}: after {} iterations the largest residual "
                    "is {:.3g} N at {}; {}",
                    summary.steps.size() + 1, trial.factor, result.iterations, result.residual,
                    system_.model().unknown_name(result.worst), remedy));
  }

  System& system_;
  const EquilibriumOptions& options_;
  bool stable_only_;
  PathNewton newton_;
  PathPoint here_;
  double done_ = 0;   // share of the path, but under arc length
  double start_ = 0;  // [m] controlled displacement at the start
  double full_step_ = 1;
  Vector last_move_;  // translations of the last step
};

}  // namespace

bool is_stable(const System& system, const Vector& u, double part) {
  const EquilibriumOptions options;
  PathNewton newton(system, options, {});
  return newton.is_minimum({.u = u, .factor = part});
}

EquilibriumSummary find_equilibrium(System& system, Vector& u, const EquilibriumOptions& options) {
  Walk walk(system, options, {}, u);
  EquilibriumSummary summary = walk.go();
  u = walk.u();
  return summary;
}

system::Vector find_rest(System& system, const RestingShape& shape) {
  const EquilibriumOptions options;
  PathNewton newton(system, options, {});
  const auto settle = [&](Vector start, bool downhill) -> std::optional<Vector> {
    // Bent in one step from the straight to the answer, not by way of the guess: until both are the same.
    PathPoint point{.u = std::move(start), .factor = 0};
    for (int round = 0; round < 20; ++round) {
      system.begin(point.u);
      const NewtonResult result = newton.iterate(point, {.downhill = downhill});
      if (!result.converged) return std::nullopt;
      if (result.iterations == 0 || (result.iterations == 1 && result.is_rounding)) break;
    }
    system.begin(point.u);
    if (!is_stable(system, point.u, 0) || !bends_little(system, point.u)) return std::nullopt;
    return point.u;
  };
  if (auto rest = settle(shape.guess, false)) return *rest;
  system.begin(shape.straight);
  if (auto near = relax(system, newton, shape.guess)) {
    if (auto rest = settle(*near, true)) return *rest;
  }
  system.begin(shape.straight);
  const EquilibriumOptions steps{.steps = 32, .max_iterations = 50, .smallest_step = 1e-6};
  Walk weight(system, steps, {.stage = Stage::dead, .held_start = shape.straight}, shape.straight);
  weight.go();
  Walk supports(system, steps, {.stage = Stage::supports, .held_start = shape.straight}, weight.u());
  supports.go();
  if (auto rest = settle(supports.u(), true)) return *rest;
  return supports.u();
}

}  // namespace strandyn::solver
