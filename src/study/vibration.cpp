#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cautions.hpp"
#include "checkpoint.hpp"
#include "cycle_log.hpp"
#include "decay.hpp"
#include "entries.hpp"
#include "outlook.hpp"
#include "plan.hpp"
#include "profile.hpp"
#include "share.hpp"
#include "strandyn/analysis/steady.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/observe/fundamental.hpp"
#include "strandyn/span/free_span.hpp"

namespace strandyn::study {

using casefile::Scene;
using observe::Cycle;

namespace {

constexpr std::size_t most_cycles_until_steady = 5000;

/// What a mean of cycles may be called.
struct MeanNames {
  const char* self_damping = "self-damping";
  const char* free_span = "self-damping of the free span";
  const char* damping_ratio = "damping ratio";
};
constexpr MeanNames of_a_steady_state{};
constexpr MeanNames of_a_decay{.self_damping = "self-damping (late in the decay)",
                               .free_span = "self-damping of the free span (late in the decay)",
                               .damping_ratio = "damping ratio (late in the decay)"};
constexpr MeanNames not_steady{.self_damping = "self-damping (not steady)",
                               .free_span = "self-damping of the free span (not steady)",
                               .damping_ratio = "damping ratio (not steady)"};

/// The mean of the last cycles and what it says of the damping.
struct SteadyRow {
  MeanNames names = of_a_steady_state;
  std::size_t cycles = 0;
  double frequency = 0;
  std::vector<std::pair<std::string, double>> mean;  ///< of the members of a cycle
  double self_damping = 0, air = 0, loss_factor = 0, damping_ratio = 0;
  std::optional<double> free_span{};
  std::optional<span::Piece> between{};  ///< the nodes of the free span
  std::optional<double> numerical_share{};
  bool is_steady = false, decays = false;
  analysis::Steadiness steadiness{};
  double steps_per_cycle = 0;
  std::optional<double> predicted{}, measured{}, expected{};
};
template <class V>
void members(V& v, SteadyRow& s) {
  v.value("cycles", s.cycles, {.what = "over how many the means were taken"});
  v.value("frequency_Hz", s.frequency, {.what = "that a cycle refers to"});
  for (auto& [key, x] : s.mean) {
    const bool amplitude = key == "antinode_amplitude_m";
    const bool friction = key == "friction_dissipation_J";
    v.value(key.c_str(), x,
            {.what = "mean of the cycles' member; the time is that of the end",
             .shown = amplitude  ? "antinode amplitude"
                      : friction ? "friction per cycle"
                                 : nullptr});
  }
  v.value("self_damping_W_per_m", s.self_damping,
          {.what = "friction, material and viscous damping over the length", .shown = s.names.self_damping});
  std::optional<double> from, to;
  if (s.between) from = s.between->from, to = s.between->to;
  v.value(
      "self_damping_free_span_W_per_m", s.free_span,
      {.what = "friction and material damping between the first and the last inner node, over the length between them",
       .shown = s.names.free_span});
  v.value("free_span_from_m", from, {.what = "the first inner node", .shown = "free span from"});
  v.value("free_span_to_m", to, {.what = "the last inner node", .shown = "free span to"});
  v.value("air_W_per_m", s.air, {.what = "still air over the length, not in the self-damping"});
  v.value("loss_factor", s.loss_factor, {.what = "twice the damping ratio"});
  v.value("damping_ratio", s.damping_ratio, {.what = "of the antinode's velocity", .shown = s.names.damping_ratio});
  v.value("numerical_share", s.numerical_share,
          {.what = "|numerical| over all physical losses", .shown = "numerical share"});
  v.value("is_steady", s.is_steady,
          {.what = "what comes in is what is lost, and neither amplitude nor loss drifts, over the last 20 cycles"});
  v.value("work_in_over_lost", s.steadiness.work_in_over_lost,
          {.what = "what the loads do over all that is lost, numerical part included, in these cycles; 1 where steady",
           .shown = s.decays ? nullptr : "work in over lost"});
  v.value("amplitude_drift", s.steadiness.amplitude_drift,
          {.what = "of a straight line through the antinode amplitudes of these cycles, of their mean"});
  v.value("loss_drift", s.steadiness.loss_drift, {.what = "the same of what is lost"});
  v.value("steps_per_cycle", s.steps_per_cycle, {.what = "of the integration"});
  v.value("predicted_numerical_damping_ratio", s.predicted, {.what = "by the formula of the integrator"});
  v.value("measured_numerical_damping_ratio", s.measured, {.what = "by the ledger"});
  v.value("expected_damping_ratio", s.expected, {.what = "for which the step was chosen"});
}

/// decay and forced: what the summary has beside the cycles.
struct VibrationSummary {
  std::optional<span::Rest> rest{};
  PlanRow plan{};
  std::optional<SteadyRow> steady{};
};
template <class V>
void members(V& v, VibrationSummary& s) {
  v.record("rest", s.rest, {.what = "how a hanging span hangs"});
  v.record("plan", s.plan, {.what = "how it was integrated"});
  v.record("steady", s.steady, {.what = "means of the last cycles"});
}

std::vector<std::pair<std::string, double>> mean_of(const std::vector<Cycle>& cycles, std::size_t last) {
  std::vector<std::pair<std::string, double>> mean;
  for (const std::string& name : results::ColumnReader::of(Cycle{}).names) mean.emplace_back(name, 0.0);
  for (std::size_t i = cycles.size() - last; i < cycles.size(); ++i) {
    const std::vector<double> values = results::ColumnReader::of(cycles[i]).values;
    for (std::size_t k = 0; k < values.size(); ++k) mean[k].second += values[k];
  }
  for (auto& [name, x] : mean) x /= static_cast<double>(last);
  mean.front().second = cycles.back().end_time;
  return mean;
}

/// Of the last cycles, as many as show whether a vibration is steady.
std::vector<analysis::CycleFlow> last_flows(const std::vector<Cycle>& cycles) {
  const std::size_t watched = std::min(cycles.size(), analysis::cycles_that_show_steadiness);
  std::vector<analysis::CycleFlow> flows;
  for (std::size_t i = cycles.size() - watched; i < cycles.size(); ++i) {
    const Cycle& c = cycles[i];
    flows.push_back({.amplitude = c.antinode_amplitude, .in = c.external_work, .lost = c.dissipated() + c.numerical});
  }
  return flows;
}

bool is_steady(const std::vector<Cycle>& cycles) {
  return analysis::is_steady(analysis::steadiness(last_flows(cycles)));
}

analysis::SpanNumbers numbers_of(const VibrationPlan& plan, const Scene& scene) {
  return {.frequency = plan.frequency,
          .length = scene.span->total_length(),
          .mass_per_length = *casefile::mass_per_length(scene)};
}

SteadyRow steady_row(const VibrationPlan& plan, const Scene& scene, const std::vector<Cycle>& cycles) {
  std::vector<analysis::CycleLosses> losses;
  for (const Cycle& c : cycles) {
    losses.push_back({.antinode_amplitude = c.antinode_amplitude,
                      .friction = c.friction,
                      .material = c.material,
                      .viscous = c.viscous,
                      .air = c.air,
                      .numerical = c.numerical});
  }
  const analysis::SteadyState s = analysis::steady_state(losses, numbers_of(plan, scene));
  SteadyRow row{.cycles = s.cycles,
                .frequency = plan.frequency,
                .mean = mean_of(cycles, s.cycles),
                .self_damping = s.self_damping,
                .air = s.air * plan.frequency / scene.span->total_length(),
                .loss_factor = s.loss_factor,
                .damping_ratio = s.damping_ratio,
                .numerical_share = s.numerical_share,
                .is_steady = is_steady(cycles),
                .decays = plan.decays,
                .steadiness = analysis::steadiness(last_flows(cycles)),
                .steps_per_cycle = plan.steps_per_cycle(),
                .predicted = plan.numerical_damping_ratio,
                .expected = plan.expected_damping_ratio};
  double energy = 0, numerical = 0;
  for (std::size_t i = cycles.size() - s.cycles; i < cycles.size(); ++i) {
    energy += cycles[i].kinetic + cycles[i].elastic;
    numerical += cycles[i].numerical;
  }
  if (energy > 0) row.measured = numerical / (4 * std::numbers::pi * energy);
  if (!row.is_steady) row.names = row.decays ? of_a_decay : not_steady;
  return row;
}

/// The loss of the free span, where the vibration has one.
void add_free_span(const span::SpanAtRest& span, const observe::Profile& profile, const Eigen::VectorXcd& motion,
                   double loop_length, SteadyRow& row) {
  row.between = span::free_span_of(span, motion, loop_length);
  if (!row.between) return;
  const std::vector<double> lengths = span::section_lengths(span, *row.between);
  double lost = 0;
  for (std::size_t point = 0; point < lengths.size(); ++point) lost += lengths[point] * profile.self_damping(point);
  row.free_span = lost * row.frequency / row.between->length();
}

/// A mean over cycles that are on their way is no steady state.
void warn_where_not_steady(const SteadyRow& row, Outcome& outcome) {
  if (row.is_steady || row.decays) return;
  std::string why = "nothing is lost";
  if (row.steadiness.work_in_over_lost) {
    why = fmt::format("the loads do {:.4g} times the work that is lost, the loss drifts by {:.2g} %",
                      *row.steadiness.work_in_over_lost, 100 * row.steadiness.loss_drift);
  }
  outcome.warnings.push_back(fmt::format(
      "not steady: over the last {} cycles {}, and the antinode amplitude drifts by {:.2g} %; their means are no "
      "steady state: give more [analysis] cycles, or until = \"steady\"",
      row.cycles, why, 100 * row.steadiness.amplitude_drift));
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
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    span::SpanAtRest span(built_);
    span.apply_static_loads();
    const VibrationPlan plan = plan_vibration(scene_, integration_, ask_, span);
    add_vibration(plan, integration_, span, outlook);
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
  if (hooks.announce) hooks.announce(words_of(plan, integration_));

  const double loop_length = span.built.loop_length(plan.frequency);
  warn_of_coarse_mesh(span, loop_length, outcome);
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
  observe::Observer* const observers[] = {&cycles, &log, &fundamental, &progress, &check};
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
  solver::IntegratorOptions options = integration_.options(plan.step, duration, plan.drives);
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
  }
  outcome.tell(summary);
  log.add_to(outcome);
  add_figures(scene_, outcome);
  if (plan.decays) add_decay(log.rows(), numbers, outcome);
  add_profile(profile, outcome);
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
