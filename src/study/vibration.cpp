#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cautions.hpp"
#include "checkpoint.hpp"
#include "clamp_stress.hpp"
#include "cycle_log.hpp"
#include "decay.hpp"
#include "entries.hpp"
#include "field_writer.hpp"
#include "findings.hpp"
#include "motion.hpp"
#include "outlook.hpp"
#include "plan.hpp"
#include "profile.hpp"
#include "section_loops.hpp"
#include "share.hpp"
#include "slip_cycle.hpp"
#include "steady_row.hpp"
#include "strandyn/observe/fundamental.hpp"

namespace strandyn::study {

using casefile::Scene;
using observe::Cycle;

namespace {

constexpr std::size_t most_cycles_until_steady = 5000;

/// decay and forced: what the summary has beside the cycles.
struct VibrationSummary {
  std::optional<span::Rest> rest{};
  PlanRow plan{};
  std::optional<WindRow> wind{};
  std::optional<SteadyRow> steady{};
};
template <class V>
void members(V& v, VibrationSummary& s) {
  v.record("rest", s.rest, {.what = "how a hanging span hangs"});
  v.record("plan", s.plan, {.what = "how it was integrated"});
  v.record("wind", s.wind, {.what = "the wind, where there is one"});
  v.record("steady", s.steady, {.what = "means of the last cycles"});
}

/// A curve says nothing of amplitudes that its tunnel has not seen.
void warn_beyond_curve(const WindRow& wind, double amplitude, Outcome& outcome) {
  if (!wind.lowest) return;
  const double a = amplitude / wind.diameter;
  if (a >= *wind.lowest && a <= *wind.highest) return;
  outcome.warnings.push_back(
      fmt::format("the vibration ends at A/D = {:.3g}, outside the range of the curve of wind power, {:.3g} to {:.3g}",
                  a, *wind.lowest, *wind.highest));
}

/// Tells how far the run is.
class ProgressReport final : public observe::Observer {
 public:
  ProgressReport(const VibrationPlan& plan, const Hooks& hooks, const observe::CycleObserver& cycles)
      : plan_(plan), hooks_(hooks), cycles_(cycles) {}
  void begin(const system::System&, const observe::StepRecord&) override {}
  void archive(Archive&) override {}
  void step(const system::System&, const observe::StepRecord& record) override {
    if (!hooks_.progress) return;
    const double end = static_cast<double>(plan_.cycles) / plan_.frequency;
    const double amplitude = cycles_.cycles().empty() ? 0 : cycles_.cycles().back().antinode_amplitude;
    hooks_.progress(record.time / end, fmt::format("t = {:.3f} s, cycle {} of {}, antinode {:.3g} mm", record.time,
                                                   cycles_.count(), plan_.cycles, 1e3 * amplitude));
  }

 private:
  const VibrationPlan& plan_;
  const Hooks& hooks_;
  const observe::CycleObserver& cycles_;
};

/// A wave wants some elements: with fewer than four a loop, frequencies and losses are the mesh's own.
void warn_of_coarse_mesh(const span::SpanAtRest& span, double loop_length, Outcome& outcome) {
  constexpr double least_per_loop = 4;
  const double longest = span::longest_element(span);
  if (longest * least_per_loop <= loop_length) return;
  outcome.warnings.push_back(fmt::format(
      "the longest element, {:.3g} m, is more than 1/4 of a loop ({:.3g} m): give more [span] elements, or \"auto\"",
      longest, loop_length));
}

void add_figures(const Scene& scene, Outcome& outcome) {
  const std::vector<std::string> lost = loss_columns(scene);
  std::vector<std::string> drawn = {"external_work_J"},
                           columns = {"cycle", "t_s", "antinode_amplitude_m", "external_work_J"};
  if (!scene.winds.empty()) {
    drawn.emplace_back("wind_work_J");
    columns.emplace_back("wind_work_J");
  }
  drawn.insert(drawn.end(), lost.begin(), lost.end());
  drawn.emplace_back("numerical_dissipation_J");
  columns.insert(columns.end(), lost.begin(), lost.end());
  columns.insert(columns.end(), {"numerical_dissipation_J", "elements_slipping"});
  outcome.figures.push_back({.name = "energy_per_cycle",
                             .title = "Energy per cycle",
                             .table = "cycles.csv",
                             .x = "cycle",
                             .y = drawn,
                             .caption = "Where the work of a cycle goes. The numerical part is what the ledger leaves "
                                        "over: the error of the time integration, and no physics."});
  outcome.figures.push_back(
      {.name = "amplitude",
       .title = "Antinode amplitude",
       .table = "cycles.csv",
       .x = "cycle",
       .y = {"antinode_amplitude_m"},
       .caption = "Half of peak to peak over a cycle, at the largest antinode away from the ends."});
  outcome.shown.push_back({.title = "Energy of each cycle", .table = "cycles.csv", .columns = columns});
}

/// A decay, or a forced vibration until a number of cycles or a steady state.
class Vibration final : public Analysis {
 public:
  Vibration(const Scene& scene, PlanAsk ask)
      : scene_(scene), ask_(ask), integration_(scene), built_(build::build_span(scene)) {
    check_plan(scene, built_, ask_);
    check_clamps(scene);
    check_output(scene);
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    span::SpanAtRest span(built_);
    span.apply_static_loads();
    const VibrationPlan plan = plan_vibration(scene_, integration_, ask_, span);
    add_vibration(scene_, plan, integration_, span, outlook);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override;

 private:
  const Scene& scene_;
  PlanAsk ask_;
  build::Integration integration_;
  build::BuiltSpan built_;
};

void Vibration::run(const Hooks& hooks, Outcome& outcome) {
  CheckpointFile checkpoint(scene_, hooks);
  span::SpanAtRest span(built_);
  VibrationSummary summary{.rest = span::rest_of(span)};
  span.apply_static_loads();
  warn_of_rest(scene_, span, outcome);
  PlanAsk ask = ask_;
  ask.stop = hooks.stop;
  const VibrationPlan plan = plan_vibration(scene_, integration_, ask, span);
  summary.plan = row_of(plan);
  summary.wind = plan.wind;
  if (hooks.announce) hooks.announce(words_of(plan, integration_));

  const double loop_length = span.built.loop_length(plan.frequency);
  if (!scene_.span->elements_per_loop) warn_of_coarse_mesh(span, loop_length, outcome);  // else its error is estimated
  const double duration = static_cast<double>(plan.cycles) / plan.frequency;
  if (plan.decays) warn_of_blows(built_, plan.drives, duration, outcome);
  const analysis::SpanNumbers numbers = numbers_of(plan, scene_);
  CycleLog::DampingRatio of_decay;
  if (plan.decays) of_decay = [&](const Cycle& cycle) { return damping_ratio_of(cycle, numbers); };
  CycleLog log(hooks.folder, of_decay);
  observe::CycleObserver cycles({.period = 1 / plan.frequency,
                                 .loop_length = loop_length,
                                 .most = 2 * analysis::cycles_that_show_steadiness,
                                 .each = [&](const Cycle& cycle) { log.add(cycle); }});
  observe::Fundamental fundamental({.period = 1 / plan.frequency});
  ProgressReport progress(plan, hooks, cycles);
  observe::CheckpointCheck check(cycles.ledger(), duration);
  std::vector<observe::Observer*> observers = {&cycles, &log, &fundamental, &progress};
  std::optional<ClampObserver> clamps;
  if (scene_.clamps) observers.push_back(&clamps.emplace(scene_, span, plan.frequency));
  SectionLoops loops(plan.frequency, loop_length);
  observers.push_back(&loops);
  std::optional<FieldWriter> fields;
  if (scene_.output) observers.push_back(&fields.emplace(scene_, hooks, plan.frequency));
  observers.push_back(&check);  // what it reads last judges all before
  bool interrupted = false;
  bool steady = false;
  std::size_t judged = 0;
  const auto stop = [&] {
    if (plan.until_steady && cycles.count() > judged) {
      judged = cycles.count();
      steady = judged >= 2 * analysis::cycles_that_show_steadiness && is_steady(cycles.cycles());
    }
    interrupted = !steady && hooks.stop && hooks.stop();  // a steady run has come to its end
    return interrupted || steady;
  };
  solver::IntegratorOptions options = integration_.options(plan.step, duration, plan.drives, plan.frequency);
  options.stop = stop;
  options.checkpoints = checkpoint.checkpoints([&] { return interrupted; });
  const solver::IntegratorSummary run = checkpoint.take_up(check, [&] {
    return solver::integrate(span.system, {.u = span.u, .v = plan.velocity}, options, integration_.method(), observers);
  });

  add_integration(run, span.system, outcome);
  const observe::Profile profile = cycles.profile(span.system);
  if (cycles.count() > 0) {
    summary.steady = steady_row(plan, scene_, cycles.cycles());
    add_free_span(span, profile, fundamental.motion(), loop_length, *summary.steady);
    warn_where_not_steady(*summary.steady, outcome);
    if (plan.wind) warn_beyond_curve(*plan.wind, cycles.cycles().back().antinode_amplitude, outcome);
  }
  outcome.tell(summary);
  if (summary.steady) outcome.findings = findings_of(*summary.steady, profile, scene_.span->total_length());
  log.add_to(outcome);
  add_figures(scene_, outcome);
  if (plan.decays) add_decay(log.rows(), numbers, outcome);
  if (clamps && cycles.count() > 0) clamps->add_to(cycles.cycles().back().antinode_amplitude, outcome);
  add_profile(profile, outcome);
  loops.add_to(outcome);
  add_slip_cycle(scene_, span, loops.strains(), outcome);
  if (fields) fields->end(outcome);
  if (cycles.count() > 0) add_motion(span, fundamental, outcome);
  outcome.ended_early = interrupted || run.ending == solver::Ending::failed;
  if (run.ending == solver::Ending::failed) {
    outcome.exit_code = ExitCode::not_converged;
    outcome.message = run.failure;
  } else if (interrupted) {
    outcome.exit_code = ExitCode::interrupted;
    outcome.message = fmt::format("interrupted at t = {:.6g} s after {} whole cycles; what was computed is kept",
                                  run.end_time, cycles.count());
  } else if (plan.until_steady && !steady) {
    outcome.exit_code = ExitCode::not_converged;
    outcome.message =
        fmt::format("not steady after {} cycles; give [analysis] cycles, or a stronger damping", cycles.count());
  }
  if (!summary.steady) return;
  check_numerical_share(scene_, integration_, plan, account_of(built_, cycles, summary.steady->cycles), outcome);
}

}  // namespace

std::vector<results::MemberNote> notes_of_vibration() {
  std::vector<results::MemberNote> notes = results::ReferenceWriter::of<VibrationSummary>();
  std::ranges::move(CycleLog::notes(), std::back_inserter(notes));
  std::ranges::move(ClampObserver::notes(), std::back_inserter(notes));
  std::ranges::move(FieldWriter::notes(), std::back_inserter(notes));
  std::ranges::move(notes_of_slip_cycle(), std::back_inserter(notes));
  return notes;
}

std::vector<results::MemberNote> notes_of_decay_analysis() {
  std::vector<results::MemberNote> notes = notes_of_vibration();
  std::ranges::move(notes_of_decay(), std::back_inserter(notes));
  return notes;
}

std::unique_ptr<Analysis> prepare_decay(const Scene& scene) {
  const auto& decay = scene.as<casefile::DecayAnalysis>();
  return std::make_unique<Vibration>(scene, PlanAsk{.mode = decay.mode,
                                                    .antinode_amplitude = decay.antinode_amplitude,
                                                    .cycles = static_cast<std::size_t>(decay.cycles)});
}

std::unique_ptr<Analysis> prepare_forced(const Scene& scene) {
  const auto& forced = scene.as<casefile::ForcedAnalysis>();
  return std::make_unique<Vibration>(
      scene, PlanAsk{.cycles = forced.cycles ? static_cast<std::size_t>(*forced.cycles) : most_cycles_until_steady,
                     .until_steady = !forced.cycles.has_value()});
}

}  // namespace strandyn::study
