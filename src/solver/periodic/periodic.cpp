#include "strandyn/solver/periodic/periodic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "periodic_balance.hpp"

namespace strandyn::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using system::Vector;

namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Corrections that fall slower than this ask for the derivatives of the sections anew.
constexpr double slow = 0.3;
/// Sections that slip no more than makes them softer by this are not asked for derivatives from the start.
constexpr double slight = 0.05;
/// So many corrections without one smaller than all before lead nowhere.
constexpr int most_astray = 6;
constexpr double shortest_part = 0.25;
/// A solution farther away than this many steps lies on another branch.
constexpr double farthest = 2;
/// A motion that drowns by more than this in the rounding of coordinates is no answer.
constexpr double most_rounding = 1e-3;
/// A drive is known to the tolerance times itself, or times this part of the force of inertia (of the amplitude).
constexpr double smallest_drive = 1e-4;

std::complex<double> control_swing(const HarmonicBalance& balance, const MatrixXd& x) {
  const auto i = static_cast<Index>(balance.control());
  return {x(i, 1), -x(i, 2)};
}

using ClosingRule = std::function<Closings(const PeriodicPoint&)>;

Closing given_drive(const PeriodicPoint& point, double drive) {
  return {.gap = point.drive - drive, .by_drive = 1};
}

ClosingRule at_resonance(const HarmonicBalance& balance, DriveKind kind, double amplitude) {
  return [&balance, kind, amplitude](const PeriodicPoint& point) {
    const std::size_t quadrature = kind == DriveKind::force ? balance.drive() : balance.control();
    const std::complex<double> z = control_swing(balance, point.x);
    const double size = std::abs(z);
    return Closings{
        Closing{.gap = point.x(static_cast<Index>(quadrature), 1), .terms = {{quadrature, 1, 1.0}}},
        Closing{.gap = size - amplitude,
                .terms = {{balance.control(), 1, z.real() / size}, {balance.control(), 2, -z.imag() / size}}}};
  };
}

ClosingRule forced_at(double omega, double drive) {
  return [omega, drive](const PeriodicPoint& point) {
    return Closings{Closing{.gap = point.omega - omega, .by_omega = 1}, given_drive(point, drive)};
  };
}

/// A length along the curve (z, w): weights make a step of one the largest that is wanted.
struct Arc {
  PeriodicPoint base, direction;
  double swing_weight = 0, omega_weight = 0;
  double length = 0;

  Closing closing(const HarmonicBalance& balance, const PeriodicPoint& point) const {
    const auto i = static_cast<Index>(balance.control());
    Closing closing{.gap = -length};
    for (Index a : {1, 2}) {
      const double factor = swing_weight * direction.x(i, a);
      closing.terms.push_back({balance.control(), a, factor});
      closing.gap += factor * (point.x(i, a) - base.x(i, a));
    }
    closing.by_omega = omega_weight * direction.omega;
    closing.gap += closing.by_omega * (point.omega - base.omega);
    return closing;
  }
};

/// [-] length of a change as the arc measures it.
double size_of(const Arc& arc, const HarmonicBalance& balance, const MatrixXd& x, double omega) {
  return std::sqrt(arc.swing_weight * std::norm(control_swing(balance, x)) + arc.omega_weight * omega * omega);
}

void advance(PeriodicPoint& point, const PeriodicPoint& change, double part) {
  point.x += part * change.x;
  point.omega += part * change.omega;
  point.drive += part * change.drive;
}

/// A state with what belongs to it.
struct Solved {
  PeriodicPoint point;
  BalanceEvaluation at;
  SectionModel model;
  PeriodicSolution solution;
};

class Newton {
 public:
  Newton(const system::System& system, const HarmonicBalance& balance, const PeriodicSetup& setup,
         const PeriodicOptions& options)
      : system_(system), balance_(balance), setup_(setup), options_(options) {}

  Solved solve(const PeriodicPoint& start, const ClosingRule& rule, const SectionModel* known = nullptr) const {
    Solved s{.point = start, .at = {}, .model = {}, .solution = {}};
    PeriodicSolution& solution = s.solution;
    double before = 0, least = INFINITY;
    double part = 1;  // of a correction that is taken: less where corrections do not fall
    int since_least = 0;
    bool probed = false;  // do the derivatives that are there serve once more?
    if (std::optional<SectionModel> carried = known ? balance_.carried_model(*known) : std::nullopt) {
      s.model = std::move(*carried);
      probed = true;
    }
    for (solution.iterations = 1; solution.iterations <= options_.max_iterations; ++solution.iterations) {
      s.at = balance_.evaluate(s.point);
      solution.effort += s.at.loops.effort;
      const bool is_slow = before > 0 && solution.correction > slow * before;
      const double last = solution.correction;
      before = last;
      if (!probed) s.model = balance_.secant_model(s.at);
      if (is_slow || (!probed && balance_.softening(s.model) > slight)) {
        s.model = balance_.probed_model(s.at);
        solution.effort += s.model.effort;
        probed = true;
      }
      PeriodicPoint change;
      if (!balance_.correct(s.point, s.at, s.model, rule(s.point), change)) {
        solution.failure = "the equations are singular: is the control near an antinode, and can the drive move it?";
        break;
      }
      solution.correction = measure(s.point, change);
      if (!std::isfinite(solution.correction)) break;
      const double amplitude = std::abs(control_swing(balance_, s.point.x + change.x));
      const double rounding = rounding_of(amplitude);
      if (rounding > most_rounding) {
        solution.failure = fmt::format(
            "the amplitude drowns in the rounding of coordinates: above {:.1g} m it can be told to one per mille",
            amplitude * rounding / most_rounding);
        break;
      }
      // Of a motion so small, loops close no better.
      const bool is_tiny = rounding > options_.tolerance;
      if (solution.correction <= (is_tiny ? rounding : options_.tolerance)) {
        solution.converged = s.at.loops.gap <= (is_tiny ? std::max(options_.closure, rounding) : options_.closure);
        break;
      }
      if (solution.correction < least) {
        least = solution.correction;
        since_least = 0;
      } else if (++since_least == most_astray) {
        break;
      }
      // As if all were linear, a correction would leave 1 - part of the next.
      if (last > 0 && solution.correction > (1 - part / 4) * last) {
        part = std::max(part / 2, shortest_part);
      } else if (solution.correction < (1 - part / 2) * last) {
        part = std::min(1.0, 2 * part);
      }
      advance(s.point, change, part * bounded(s.point, change));
    }
    solution.iterations = std::min(solution.iterations, options_.max_iterations);
    describe(s);
    if (solution.converged && !s.model.slipping.empty()) {
      solution.state.sections = std::make_shared<SectionModel>(s.model);
    }
    return s;
  }

 private:
  /// [-] of the amplitude: places along the chain are known to the last digit of its length, and small motions to no
  /// more than that.
  double rounding_of(double amplitude) const {
    const double length = system_.model().unstressed_length();
    return std::numeric_limits<double>::epsilon() * length / amplitude;
  }

  /// Largest change relative to what it changes.
  double measure(const PeriodicPoint& point, const PeriodicPoint& change) const {
    const double size = std::abs(control_swing(balance_, point.x + change.x));
    double largest = 0;
    for (std::size_t i = 0; i < system_.unknowns(); ++i) {
      if (model::is_rotation(system_.model().kind(i))) continue;
      largest = std::max(largest, change.x.row(static_cast<Index>(i)).cwiseAbs().maxCoeff());
    }
    const double omega = point.omega + change.omega;
    const double unit = setup_.kind == DriveKind::force ? balance_.total_mass() * omega * omega * size : size;
    const double drive = std::max(std::abs(point.drive + change.drive), smallest_drive * unit);
    return std::max({largest / size, std::abs(change.omega / omega), std::abs(change.drive) / drive});
  }

  /// The part of a correction that is taken: not beyond where linear answers mean something.
  double bounded(const PeriodicPoint& point, const PeriodicPoint& change) const {
    double part = std::min(1.0, 0.1 * point.omega / std::max(std::abs(change.omega), 1e-300));
    const double size = std::abs(control_swing(balance_, point.x));
    if (size > 0) part = std::min(part, 0.5 * size / std::max(std::abs(control_swing(balance_, change.x)), 1e-300));
    return part;
  }

  void describe(Solved& s) const {
    PeriodicSolution& solution = s.solution;
    solution.state = {.frequency = s.point.omega / turn, .drive = s.point.drive, .harmonics = s.point.x};
    solution.amplitude = std::abs(control_swing(balance_, s.point.x));
    Index i = 0;
    Index a = 0;
    solution.residual = s.at.residual.cwiseAbs().maxCoeff(&i, &a);
    solution.cycles = s.at.loops.cycles;
    solution.loop_gap = s.at.loops.gap;
    balance_.account(s.point, s.at, solution);
    if (solution.converged) return;
    if (s.at.loops.gap > options_.closure) {
      solution.failure = fmt::format("the loop of section point {} is open by {:.3g} after {} cycles", s.at.loops.worst,
                                     s.at.loops.gap, s.at.loops.cycles);
    } else if (solution.failure.empty()) {
      solution.failure = fmt::format(
          "no convergence in {} iterations: last correction {:.3g}, largest imbalance {:.3g} "
          "in harmonic {} of {}",
          solution.iterations, solution.correction, solution.residual, (a + 1) / 2,
          system_.model().unknown_name(static_cast<std::size_t>(i)));
    }
    solution.failure =
        fmt::format("periodic response at {:.6g} Hz, amplitude {:.4g}, drive {:.4g}: {}", solution.state.frequency,
                    solution.amplitude, solution.state.drive, solution.failure);
  }

  const system::System& system_;
  const HarmonicBalance& balance_;
  const PeriodicSetup& setup_;
  const PeriodicOptions& options_;
};

PeriodicPoint point_of(const PeriodicState& state) {
  return {.x = state.harmonics, .omega = turn * state.frequency, .drive = state.drive};
}

/// The same motion half a cycle later: the drive changes its sign.
void shift_half_a_cycle(PeriodicState& state) {
  for (Index a = 1; a < state.harmonics.cols(); ++a) {
    if ((a + 1) / 2 % 2 == 1) state.harmonics.col(a) *= -1;
  }
  state.drive = -state.drive;
}

}  // namespace

void PeriodicOptions::validate() const {
  const auto need = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(fmt::format("PeriodicOptions: {}", what));
  };
  need(harmonics >= 1, "harmonics must be 1 or more");
  need(samples >= 4 * harmonics + 4, "samples must be 4 harmonics + 4 or more");
  need(samples % 2 == 0, "samples must be even");
  need(tolerance > 0 && tolerance < 1, "tolerance must lie between 0 and 1");
  need(max_iterations >= 1, "max_iterations must be 1 or more");
  need(max_cycles >= 2, "max_cycles must be 2 or more");
  need(closure > 0, "closure must be positive");
  need(probe > 0 && probe < 0.1, "probe must lie between 0 and 0.1");
}

std::complex<double> PeriodicState::phasor(std::size_t i, int k) const {
  const auto row = static_cast<Index>(i);
  if (k == 0) return harmonics(row, 0);
  return {harmonics(row, 2 * k - 1), -harmonics(row, 2 * k)};
}

double PeriodicSolution::imbalance() const {
  const double work = drive_power / state.frequency;
  return (work - loop_work - material - viscous.total() - air) / work;
}

PeriodicSolver::PeriodicSolver(const system::System& system, Vector rest, PeriodicSetup setup, PeriodicOptions options)
    : system_(system), rest_(std::move(rest)), setup_(setup), options_(options) {
  options_.validate();
  HarmonicBalance(system_, rest_, setup_, options_);  // throws where it cannot be
}

PeriodicState PeriodicSolver::from_mode(const Mode& mode, double amplitude) const {
  const HarmonicBalance balance(system_, rest_, setup_, options_);
  PeriodicState state = from_rest(mode.frequency, 0);
  state.harmonics.col(2) = mode.shape * (amplitude / mode.shape(static_cast<Index>(balance.control())));
  if (state.harmonics(static_cast<Index>(balance.drive()), 2) < 0) state.harmonics.col(2) *= -1;
  return state;
}

PeriodicState PeriodicSolver::from_rest(double frequency, double drive) const {
  return {
      .frequency = frequency, .drive = drive, .harmonics = MatrixXd::Zero(rest_.size(), 2 * options_.harmonics + 1)};
}

PeriodicSolution PeriodicSolver::resonance(double amplitude, const PeriodicState& start) const {
  if (!(amplitude > 0)) throw std::invalid_argument("periodic response: the amplitude of a resonance must be positive");
  const HarmonicBalance balance(system_, rest_, setup_, options_);
  const Newton newton(system_, balance, setup_, options_);
  PeriodicSolution solution =
      newton.solve(point_of(start), at_resonance(balance, setup_.kind, amplitude), start.sections.get()).solution;
  if (solution.state.drive < 0) {
    shift_half_a_cycle(solution.state);
    solution.state.sections.reset();  // of the other half
  }
  return solution;
}

PeriodicSolution PeriodicSolver::forced(double frequency, double drive) const {
  return forced(frequency, drive, from_rest(frequency, drive));
}

PeriodicSolution PeriodicSolver::forced(double frequency, double drive, const PeriodicState& start) const {
  const HarmonicBalance balance(system_, rest_, setup_, options_);
  const Newton newton(system_, balance, setup_, options_);
  return newton.solve(point_of(start), forced_at(turn * frequency, drive)).solution;
}

std::vector<PeriodicSolution> PeriodicSolver::sweep(const SweepOptions& sweep) const {
  if (!(sweep.frequency_step > 0 && sweep.swing_step > 0 && sweep.from > 0 && sweep.to > 0)) {
    throw std::invalid_argument("periodic sweep: frequencies and steps must be positive");
  }
  const HarmonicBalance balance(system_, rest_, setup_, options_);
  const Newton newton(system_, balance, setup_, options_);
  const double heading = sweep.to > sweep.from ? 1 : -1;
  std::vector<PeriodicSolution> solutions;
  const auto goes_on = [&] { return solutions.back().converged && (!sweep.each || sweep.each(solutions.back())); };
  PeriodicPoint start = point_of(from_rest(sweep.from, sweep.drive));
  Solved here = newton.solve(start, forced_at(start.omega, sweep.drive));
  solutions.push_back(here.solution);
  if (!goes_on()) return solutions;

  Closings ahead = forced_at(start.omega, sweep.drive)(here.point);
  ahead[0].by_omega = heading;
  double part = 1;  // of the largest step
  while (solutions.size() < sweep.max_points && heading * (here.point.omega - turn * sweep.to) < 0) {
    Arc arc{.base = here.point, .direction = {}};
    if (!balance.direction(here.point, here.at, here.model, ahead, arc.direction)) break;
    const double swing_unit = sweep.swing_step * here.solution.amplitude;
    arc.swing_weight = 1 / (swing_unit * swing_unit);
    arc.omega_weight = 1 / std::pow(turn * sweep.frequency_step, 2);
    const double size = size_of(arc, balance, arc.direction.x, arc.direction.omega);
    arc.direction.x /= size;
    arc.direction.omega /= size;
    arc.direction.drive = 0;
    Solved next;
    for (;; part /= 2) {
      arc.length = part;
      PeriodicPoint predicted = here.point;
      advance(predicted, arc.direction, part);
      next = newton.solve(predicted, [&](const PeriodicPoint& point) {
        return Closings{arc.closing(balance, point), given_drive(point, sweep.drive)};
      });
      const double distance = size_of(arc, balance, next.point.x - here.point.x, next.point.omega - here.point.omega);
      if (next.solution.converged && distance > farthest * part) {
        next.solution.converged = false;
        next.solution.failure = fmt::format("periodic sweep: lost the curve beyond {:.6g} Hz, amplitude {:.4g}",
                                            here.solution.state.frequency, here.solution.amplitude);
      }
      if (next.solution.converged || part < sweep.smallest_step) break;
    }
    if (next.solution.converged && heading * (next.point.omega - turn * sweep.to) > 0) {
      next = newton.solve(next.point, forced_at(turn * sweep.to, sweep.drive));
      next.point.omega = turn * sweep.to;
    }
    solutions.push_back(next.solution);
    if (!goes_on()) break;
    if (next.solution.iterations <= 5) part = std::min(1.0, 1.5 * part);
    ahead = Closings{arc.closing(balance, next.point), given_drive(next.point, sweep.drive)};
    here = std::move(next);
  }
  return solutions;
}

}  // namespace strandyn::solver
