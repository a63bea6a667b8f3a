#include "strandyn/solver/time/generalized_alpha.hpp"

#include <fmt/format.h>

#include "alpha_stepper.hpp"
#include "checkpoint.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {
namespace {

/// Parts of a step that do not converge, in powers of two.
constexpr int parts = 1024;

/// Commits a state that was accepted and tells the observers.
class Announcer {
 public:
  Announcer(system::System& system, const AlphaStepper& stepper, std::span<observe::Observer* const> observers)
      : system_(system), stepper_(stepper), observers_(observers) {}

  void begin() {
    const observe::StepRecord record = accept(0);
    for (observe::Observer* observer : observers_) observer->begin(system_, record);
  }
  void step(double length) {
    const observe::StepRecord record = accept(length);
    const Stopwatch::Lap lap(system_.stopwatch(), Part::observers);
    for (observe::Observer* observer : observers_) observer->step(system_, record);
  }

 private:
  observe::StepRecord accept(double length) {
    return {.time = stepper_.time(),
            .step = length,
            .order = length > 0 ? 2 : 0,
            .u = stepper_.u(),
            .v = stepper_.v(),
            .a = stepper_.w(),
            .accepted = system_.commit(stepper_.u().data())};
  }

  system::System& system_;
  const AlphaStepper& stepper_;
  std::span<observe::Observer* const> observers_;
};

/// Where the whole steps end: at multiples of the step and at corners, which cut one in two.
class Grid {
 public:
  Grid(const model::Model& model, const IntegratorOptions& options)
      : step_(options.step), corners_(corner_times(model, options.end_time)) {}

  void archive(Archive& a) { a(corner_, done_); }
  bool finished() const { return corner_ == corners_.size(); }
  /// [s] the end of the step at hand.
  double target() const { return at_corner() ? corners_[corner_] : next_multiple(); }
  bool at_corner() const { return corners_[corner_] <= next_multiple() + rounding(); }
  /// To the next step. True where it begins at a corner.
  bool advance() {
    if (!at_corner()) {
      ++done_;
      return false;
    }
    while (next_multiple() <= corners_[corner_] + rounding()) ++done_;
    return ++corner_ != corners_.size();
  }

 private:
  double next_multiple() const { return static_cast<double>(done_ + 1) * step_; }
  double rounding() const { return 1e-6 * step_; }

  double step_;
  std::vector<double> corners_;
  std::size_t corner_ = 0;
  std::size_t done_ = 0;  // whole multiples
};

class Run {
 public:
  Run(system::System& system, const InitialMotion& initial, const IntegratorOptions& options, GeneralizedAlpha method,
      std::span<observe::Observer* const> observers)
      : system_(system),
        options_(options),
        observers_(observers),
        stepper_(system, initial, options, method),
        announcer_(system, stepper_, observers),
        grid_(system.model(), options) {}

  IntegratorSummary go() {
    announcer_.begin();
    resume(options_.checkpoints, system_, *this, observers_);
    while (!grid_.finished()) {
      if (!reach(grid_.target())) break;
      whole_ = {.start = stepper_.time()};
      if (grid_.advance()) stepper_.restart();
    }
    summary_.newton_iterations = stepper_.newton_iterations();
    return summary_;
  }

  void archive(Archive& a) {
    a.same(std::string("generalized-alpha"), "integrator");
    a(stepper_, grid_, whole_, summary_.steps, summary_.rejected_steps, summary_.end_time);
  }

 private:
  /// A whole step under way.
  struct Whole {
    double start = 0;  // [s]
    int done = 0;      // of its parts
    int part = parts;  // the size of the next one
  };

  /// Goes there in one step, or else in parts. False where the run has ended early.
  bool reach(double target) {
    auto& [start, done, part] = whole_;
    while (done < parts) {
      const double before = stepper_.time();
      const double end = done + part == parts ? target : start + (target - start) * (done + part) / parts;
      if (!stepper_.step(end)) {
        ++summary_.rejected_steps;
        part /= 2;
        if (part == 0) return fail(end - before);
        continue;
      }
      ++summary_.steps;
      summary_.end_time = end;
      announcer_.step(end - before);
      if (options_.stop && options_.stop()) summary_.ending = Ending::stopped;
      stepper_.shorten_rotations();
      done += part;
      while (done < parts && done % (2 * part) == 0) part *= 2;
      keep_checkpoint(options_.checkpoints, system_, *this, observers_);
      if (summary_.ending == Ending::stopped) return false;
    }
    return true;
  }

  bool fail(double step) {
    summary_.ending = Ending::failed;
    summary_.failure = fmt::format(
        "the step at t = {:.6g} s did not converge, even cut to {:.3g} s ({} steps cut in all); largest last "
        "corrections: {}; try more [integrator] steps_per_cycle",
        stepper_.time(), step, summary_.rejected_steps, stepper_.worst_unknowns());
    return false;
  }

  system::System& system_;
  const IntegratorOptions& options_;
  std::span<observe::Observer* const> observers_;
  AlphaStepper stepper_;
  Announcer announcer_;
  Grid grid_;
  Whole whole_;
  IntegratorSummary summary_;
};

}  // namespace

double GeneralizedAlpha::damping_ratio(double angle) const {
  const double k = (1 - rho_inf) / (1 + rho_inf);
  return k * k * k * angle * angle * angle / 2;
}

double GeneralizedAlpha::frequency_error(double angle) const {
  const double k = (1 - rho_inf) / (1 + rho_inf);
  return -(1.0 / 12 + 3 * k * k / 8) * angle * angle;
}

IntegratorSummary integrate_generalized_alpha(system::System& system, const InitialMotion& initial,
                                              const IntegratorOptions& options, GeneralizedAlpha method,
                                              std::span<observe::Observer* const> observers) {
  if (!(method.rho_inf >= 0 && method.rho_inf <= 1)) throw ComputationError("rho_inf of generalized-alpha is 0 to 1");
  return Run(system, initial, options, method, observers).go();
}

}  // namespace strandyn::solver
