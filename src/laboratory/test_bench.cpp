#include "strandyn/laboratory/test_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "control.hpp"
#include "strandyn/analysis/steady.hpp"
#include "strandyn/span/trial_cycles.hpp"

namespace strandyn::laboratory {

using observe::Cycle;
using std::numbers::pi;

namespace {

constexpr double phase_tolerance = 0.02;  // [rad]
// Where a wave loses most of itself on a round trip, the rate of loss is no matter of the mode's amplitude alone, and
// corrections after few cycles chase each other: too much, too little.
constexpr int most_reversals = 3;

/// One integration at one drive.
struct Stretch {
  std::vector<Cycle> cycles;
  std::vector<std::complex<double>> modal, driven;
  bool stopped = false;
};

/// By the mode's amplitude; 1e-7 of the energy [J] is nothing.
bool is_steady(const Stretch& stretch, double energy) {
  std::vector<analysis::CycleFlow> flows;
  for (std::size_t i = 0; i < stretch.modal.size(); ++i) {
    const Cycle& cycle = stretch.cycles[i];
    flows.push_back({.amplitude = std::abs(stretch.modal[i]),
                     .in = cycle.external_work,
                     .lost = cycle.dissipated() + cycle.numerical});
  }
  return analysis::is_steady(flows, 1e-7 * energy);
}

class Bench {
 public:
  Bench(BenchSpan& bench, double antinode_amplitude, const build::Integration& integration, const BenchOptions& options,
        const BenchHooks& hooks)
      : bench_(bench),
        integration_(integration),
        keys_(options),
        wanted_(antinode_amplitude),
        hooks_(hooks),
        short_stretch_(std::max<std::size_t>(4, static_cast<std::size_t>(bench.mode_number()))),
        long_stretch_((analysis::cycles_that_show_steadiness + short_stretch_ - 1) / short_stretch_ * short_stretch_),
        way_out_(std::max<std::size_t>(4, static_cast<std::size_t>(std::lround(bench.round_trip())))),
        trial_(bench.at_rest(), bench.shape(), bench.frequency(), hooks.stop),
        exponent_(exponent()),
        control_({.modal_mass = bench.modal_mass(),
                  .coupling = bench.coupling(),
                  .moves = bench.moves(),
                  .exponent = exponent_},
                 wanted_) {
    run_.cost.steps_per_cycle = steps_per_cycle();
  }

  BenchRun go() {
    if (settle()) measure();
    if (!run_.stopped) decay();
    return run_;
  }

 private:
  /// Of the loss over the amplitude, about the wanted one.
  double exponent() {
    constexpr double share = 0.05;
    const double low = trial_.loss((1 - share) * wanted_);
    const double high = trial_.loss((1 + share) * wanted_);
    return low > 0 ? std::clamp(std::log(high / low) / std::log((1 + share) / (1 - share)), 1.0, 8.0) : 2;
  }

  int steps_per_cycle() {
    if (integration_.chooses_steps()) {
      return solver::steps_for(integration_.method(), {.damping_ratio = trial_.damping_ratio(wanted_), .share = 0.005});
    }
    const double steps = 1 / (bench_.frequency() * integration_.step_at(bench_.frequency()));
    return 4 * static_cast<int>(std::ceil(steps / 4 - 1e-9));  // quarters of a cycle are whole steps
  }

  Stretch vibrate(const Drive& drive, double cycles, observe::CycleObserver& account,
                  std::span<observe::Observer* const> instruments) {
    CyclePhasors phasors(bench_, drive);
    std::vector<observe::Observer*> observers = {&account, &phasors};
    observers.insert(observers.end(), instruments.begin(), instruments.end());
    solver::IntegratorOptions options = integration_.options(1 / (drive.frequency * run_.cost.steps_per_cycle),
                                                             cycles / drive.frequency, bench_.drives(drive));
    options.stop = hooks_.stop;
    const solver::IntegratorSummary summary =
        solver::integrate(bench_.at_rest().system, now_, options, integration_.method(), observers);
    run_.cost.steps += summary.steps;
    if (summary.ending == solver::Ending::failed) throw ComputationError(summary.failure);
    now_ = phasors.end();
    if (hooks_.tell && !account.cycles().empty()) {
      hooks_.tell(fmt::format("bench after {} cycles: antinode {:.4g} mm",
                              run_.cost.cycles_until_steady + account.cycles().size(),
                              1e3 * account.cycles().back().antinode_amplitude));
    }
    return {.cycles = account.cycles(),
            .modal = phasors.modal(),
            .driven = phasors.driven(),
            .stopped = summary.ending == solver::Ending::stopped};
  }
  Stretch vibrate(const Drive& drive, double cycles, std::span<observe::Observer* const> instruments = {}) {
    observe::CycleObserver account(account_of(drive, 1));
    return vibrate(drive, cycles, account, instruments);
  }
  observe::CycleOptions account_of(const Drive& drive, std::size_t kept) const {
    return {.period = 1 / drive.frequency, .loop_length = bench_.loop_length(), .kept = kept};
  }

  void read(const Drive& drive, const Stretch& stretch) {
    const std::size_t first = stretch.modal.size() / 4;
    const std::size_t last = stretch.modal.size() - 1;
    double amplitude = 0;
    for (std::size_t i = first; i <= last; ++i) amplitude += stretch.cycles[i].antinode_amplitude;
    const double period = 1 / drive.frequency;
    control_.read({.drive = drive,
                   .first = stretch.modal[first],
                   .last = stretch.modal[last],
                   .between = static_cast<double>(last - first) * period,
                   .after = period / 2,
                   .driven = stretch.driven[last],
                   .antinode_amplitude = amplitude / static_cast<double>(last - first + 1)});
  }

  /// From the crest of the drive, three quarters of a cycle to where it passes zero upwards.
  Stretch begin() {
    Drive drive = {.frequency = bench_.frequency(),
                   .amplitude = trial_.loss(wanted_) / (pi * wanted_ * bench_.coupling()),
                   .phase = pi / 2};
    double cycles = static_cast<double>(short_stretch_);
    if (keys_.starts_in_mode) {
      now_ = bench_.start(wanted_, drive.amplitude);
      cycles += 0.75;
    } else {
      now_ = {.u = bench_.at_rest().u, .v = bench_.at_rest().system.make_vector()};
      drive.phase = 0;
    }
    bench_.at_rest().system.begin(now_.u);
    Stretch stretch = vibrate(drive, cycles);
    if (!stretch.stopped) read(drive, stretch);
    run_.cost.cycles_until_steady = stretch.cycles.size();
    return stretch;
  }

  bool is_within(double amplitude, double phase) const {
    return std::abs(control_.amplitude_error()) <= amplitude && std::abs(control_.phase_error()) <= phase;
  }

  /// Corrections of few cycles first, unless they chase each other; then long ones, gentle enough to leave the other
  /// modes alone; then a held drive. False where it was stopped.
  bool settle() {
    if (begin().stopped) return !(run_.stopped = true);
    int reversals = 0;
    double error_before = control_.amplitude_error();
    for (;;) {
      const double tolerance = keys_.amplitude_tolerance;
      if (control_.amplitude_error() * error_before < 0) ++reversals;
      error_before = control_.amplitude_error();
      const bool near = is_within(10 * tolerance, 5 * phase_tolerance) || reversals > most_reversals;
      const bool hold = is_within(tolerance / 2, phase_tolerance / 2);
      const std::size_t cycles = near ? long_stretch_ : short_stretch_;
      if (run_.cost.cycles_until_steady + cycles > static_cast<std::size_t>(keys_.max_cycles)) give_up();
      drive_ = hold ? control_.held() : control_.corrected(static_cast<double>(cycles) / bench_.frequency());
      const Stretch stretch = vibrate(drive_, static_cast<double>(cycles));
      if (stretch.stopped) return !(run_.stopped = true);
      run_.cost.cycles_until_steady += cycles;
      read(drive_, stretch);
      if (!hold || !is_within(tolerance, phase_tolerance)) continue;
      if (is_steady(stretch, energy(std::abs(stretch.modal.back())))) return true;
    }
  }

  [[noreturn]] void give_up() const {
    throw ComputationError(fmt::format(
        "not steady after {} cycles: the antinode's amplitude is {:.3g} % off the wanted {:.4g} mm, the phase {:.3g} "
        "degrees off resonance; give more [analysis.bench] max_cycles, or a wider amplitude_tolerance",
        run_.cost.cycles_until_steady, 100 * control_.amplitude_error(), 1e3 * wanted_,
        control_.phase_error() * 180 / pi));
  }

  std::vector<observe::Observer*> watch() const {
    return hooks_.watch ? std::vector{hooks_.watch} : std::vector<observe::Observer*>{};
  }

  void measure() {
    run_.cost.evaluations_until_steady = bench_.at_rest().system.effort().evaluations;
    const auto cycles = static_cast<std::size_t>(keys_.cycles);
    observe::CycleObserver account(account_of(drive_, cycles));
    SteadyPhasors phasors(bench_, drive_, account);
    std::vector<observe::Observer*> instruments = watch();
    instruments.push_back(&phasors);
    const Stretch stretch = vibrate(drive_, static_cast<double>(cycles), account, instruments);
    run_.stopped = stretch.stopped;
    if (run_.stopped) return;
    run_.steady = {.drive = drive_,
                   .tuned_at_shaker = control_.tuned_at_shaker(),
                   .loss_exponent = exponent_,
                   .cycles = stretch.cycles,
                   .profile = account.profile(bench_.at_rest().system),
                   .force = phasors.force(),
                   .driven = phasors.driven(),
                   .motion = phasors.motion(),
                   .curvature = phasors.curvature(),
                   .moment = phasors.moment()};
    for (const std::complex<double>& q : stretch.modal) {
      run_.steady.modal_amplitude += std::abs(q) / static_cast<double>(cycles);
    }
  }

  /// [J] of the mode at an amplitude [m] of its coordinate.
  double energy(double modal_amplitude) const {
    return bench_.modal_mass() * std::pow(2 * pi * drive_.frequency * modal_amplitude, 2) / 2;
  }

  /// Let go a little above the measured amplitude, so that it is passed on the way. The further the span is pushed up,
  /// the more its decaying cycles lose at the same amplitude.
  void decay() {
    double loss = 0;
    for (const Cycle& cycle : run_.steady.cycles) loss += cycle.dissipated() / keys_.cycles;
    const double decrement = loss / (2 * energy(run_.steady.modal_amplitude));
    constexpr double cycles_above = 4, most_above = 0.1;
    Drive drive = drive_;
    for (const double part : control_.way_out(way_out_, std::min(most_above, cycles_above * decrement))) {
      drive.amplitude = part * drive_.amplitude;
      run_.stopped = vibrate(drive, 1, watch()).stopped;
      if (run_.stopped) return;
    }
    const Stretch stretch = vibrate({.frequency = drive_.frequency}, keys_.decay_cycles, watch());
    run_.stopped = stretch.stopped;
    for (const std::complex<double>& q : stretch.modal) run_.decay.push_back(std::abs(q));
    for (const Cycle& cycle : stretch.cycles) run_.decay_losses.push_back(cycle.dissipated());
  }

  BenchSpan& bench_;
  const build::Integration& integration_;
  const BenchOptions& keys_;
  double wanted_;
  const BenchHooks& hooks_;
  // [cycles] Neighbouring modes of a span are about a part 1/n of the frequency of mode n apart: a drive that lasts
  // whole multiples of n cycles leaves them nearly as it found them.
  std::size_t short_stretch_, long_stretch_;
  std::size_t way_out_;  // [cycles] up, and as many down: whole round trips of a wave
  span::TrialCycles trial_;
  double exponent_;
  Control control_;
  Drive drive_;
  solver::InitialMotion now_;
  BenchRun run_;
};

}  // namespace

BenchRun run_bench(BenchSpan& bench, double antinode_amplitude, const build::Integration& integration,
                   const BenchOptions& options, const BenchHooks& hooks) {
  try {
    return Bench(bench, antinode_amplitude, integration, options, hooks).go();
  } catch (const Interrupted&) {
    BenchRun run;
    run.stopped = true;
    return run;
  }
}

}  // namespace strandyn::laboratory
