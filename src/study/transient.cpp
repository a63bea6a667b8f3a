#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cautions.hpp"
#include "clamp_stress.hpp"
#include "entries.hpp"
#include "field_writer.hpp"
#include "outlook.hpp"
#include "plan.hpp"
#include "share.hpp"
#include "strandyn/core/kept_rows.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/observe/ledger.hpp"
#include "transient_rows.hpp"

namespace strandyn::study {

using casefile::Scene;
using span::Components;

namespace {

/// Does anything act at time 0 beside the weight? A chain without supports has no stiffness to look for a rest with.
bool is_loaded_at_start(const model::Model& model) {
  const auto acts = [](const auto& source) { return math::evaluate(source.history, 0) != 0; };
  return std::ranges::any_of(model.loads, [&](const model::Load& load) { return !load.dead && acts(load); }) ||
         std::ranges::any_of(model.motions, [](const model::PrescribedMotion& m) { return m.at(0, {}) != 0; });
}

/// The nodes whose motion is written: where the case says, or the loaded ones and the right end.
std::vector<std::size_t> probe_nodes(const Scene& scene, const model::Model& model) {
  std::vector<double> places = scene.as<casefile::TransientAnalysis>().probes;
  if (places.empty()) {
    for (const casefile::Load& load : scene.loads) {
      if (load.at) places.push_back(*load.at);
    }
    places.push_back(scene.span->total_length());
  }
  std::vector<std::size_t> nodes;
  for (double place : places) {
    const std::size_t node = model::nearest_node(model, place);
    if (std::ranges::count(nodes, node) == 0) nodes.push_back(node);
  }
  return nodes;
}

Components components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// The ledger over time.
class EnergyHistory final : public observe::Observer {
 public:
  explicit EnergyHistory(std::optional<double> rows_every) : rows_(rows_every) {}
  void begin(const system::System& system, const observe::StepRecord& initial) override {
    ledger_.begin(system, initial);
    append(initial.time);
  }
  void step(const system::System& system, const observe::StepRecord& record) override {
    ledger_.step(system, record);
    append(record.time);
  }
  void exchanged(const observe::StepRecord& record) override { ledger_.exchanged(record); }
  bool wants_forces() const override { return true; }
  EnergySummary at_end() const {
    const observe::Account& a = ledger_.now();
    EnergySummary out{.end = rows_.last(), .initial_kinetic = a.initial_kinetic, .largest_kinetic = largest_kinetic_};
    const double lost = a.dissipated();
    if (lost > 0) out.numerical_share = std::abs(a.numerical()) / lost;
    return out;
  }
  /// The whole run. What was lost along the way was there, too.
  ShareAccount account() const {
    const observe::Account& a = ledger_.now();
    return {.numerical = a.numerical(),
            .quadrature_error = a.quadrature_error,
            .lost = a.dissipated(),
            .energy = largest_energy_};
  }
  const KeptRows<EnergyRow>& rows() const { return rows_; }

 private:
  void append(double time) {
    const observe::Account& a = ledger_.now();
    largest_kinetic_ = std::max(largest_kinetic_, a.kinetic);
    largest_energy_ = std::max(largest_energy_, energy_of(a.kinetic, a.elastic));
    rows_.add(time, {.time = time,
                     .kinetic = a.kinetic,
                     .elastic = a.elastic,
                     .external_work = a.external_work,
                     .wind = a.wind,
                     .friction = a.friction,
                     .material = a.material,
                     .viscous = a.viscous.total(),
                     .air = a.air,
                     .attached = a.attached,
                     .numerical = a.numerical(),
                     .quadrature_error = a.quadrature_error});
  }

  observe::Ledger ledger_;
  KeptRows<EnergyRow> rows_;
  double largest_kinetic_ = 0, largest_energy_ = 0;  // [J] of all steps
};

class ProgressReport final : public observe::Observer {
 public:
  ProgressReport(double duration, const Hooks& hooks) : duration_(duration), hooks_(hooks) {}
  void begin(const system::System&, const observe::StepRecord&) override {}
  void step(const system::System&, const observe::StepRecord& record) override {
    if (!hooks_.progress) return;
    hooks_.progress(record.time / duration_, fmt::format("t = {:.4g} s of {:.4g} s", record.time, duration_));
  }

 private:
  double duration_;
  const Hooks& hooks_;
};

std::vector<ProbeRow> probe_rows(const observe::ProbeHistories& probes, const std::vector<double>& arc) {
  std::vector<ProbeRow> rows;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    rows.push_back({.arc = arc[probes.node(i)],
                    .displacement = {.min = components(probes.lowest(i)),
                                     .max = components(probes.highest(i)),
                                     .end = components(probes.displacements(i).back())},
                    .frequency = probes.frequency(i)});
  }
  return rows;
}

/// histories.csv, and the direction that moves most of each probe as a figure.
void add_histories(const observe::ProbeHistories& probes, const std::vector<KeptRows<EnergyRow>::Kept>& kept,
                   Outcome& outcome) {
  std::vector<std::string> names = {"t_s"};
  std::vector<std::string> drawn;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (const char* axis : {"x", "y", "z"}) names.push_back(fmt::format("probe_{}_{}_m", i + 1, axis));
    Eigen::Index axis = 0;
    (probes.highest(i) - probes.lowest(i)).maxCoeff(&axis);
    drawn.push_back(names[names.size() - 3 + static_cast<std::size_t>(axis)]);
  }
  results::Table table(names);
  std::vector<double> row;
  for (const auto& [step, energies] : kept) {
    row = {energies.time};
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const Eigen::Vector3d& d = probes.displacements(i)[step];
      row.insert(row.end(), d.begin(), d.end());
    }
    table.append(row);
  }
  outcome.tables.push_back({.file = "histories.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "histories",
                             .title = "Motion of the probes",
                             .table = "histories.csv",
                             .x = "t_s",
                             .y = drawn,
                             .caption = "Displacement of each probe from the initial state, along the direction in "
                                        "which it moves most."});
}

MomentumRow row_of(const observe::MomentumObserver& momentum) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (momentum.mass()(axis) > 0) centre(axis) = momentum.momentum()(axis) / momentum.mass()(axis);
  }
  return {.linear = components(momentum.momentum()),
          .centre_velocity = components(centre),
          .impulse = components(momentum.impulse()),
          .largest_deviation = momentum.largest_deviation()};
}

class Transient final : public Analysis {
 public:
  explicit Transient(const Scene& scene)
      : scene_(scene), integration_(scene), built_(build::build_span(scene)), ask_({.counts_cycles = false}) {
    if (scene.integrator.checkpoint_every) {
      refuse(scene.source, "integrator.checkpoint_every_s", "a transient analysis writes no checkpoints",
             "leave the key out");
    }
    check_plan(scene, built_, ask_);
    check_clamps(scene);
    check_output(scene);
    if (scene.as<casefile::TransientAnalysis>().start == casefile::Start::unloaded) {
      for (std::size_t i = 0; i < built_.model.motions.size(); ++i) {
        if (built_.model.motions[i].at(0, {}) == 0) continue;
        refuse(scene.source, fmt::format("motion[{}]", built_.motion_of[i]),
               "is away from 0 at t = 0, where analysis.start = \"unloaded\" has the span at rest",
               "let its history begin at 0, or give start = \"loaded\"");
      }
    }
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    span::SpanAtRest span(built_);
    stand_ready(span);
    const VibrationPlan plan = plan_vibration(scene_, integration_, ask_, span);
    add_steps(scene_.as<casefile::TransientAnalysis>().duration / plan.step, plan, integration_, span, outlook);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    span::SpanAtRest span(built_);
    TransientSummary summary{.rest = span::rest_of(span)};
    stand_ready(span);
    warn_of_rest(scene_, span, outcome);
    if (!scene_.as<casefile::TransientAnalysis>().start && is_loaded_at_start(span.built.model)) {
      outcome.warnings.emplace_back(
          "what acts at t = 0 belongs to the state of rest, in which the span stands before the start; "
          "analysis.start = \"unloaded\" makes it act suddenly, \"loaded\" says that this is meant");
    }
    const VibrationPlan plan = plan_vibration(scene_, integration_, ask_, span);
    summary.plan = study::row_of(plan);
    summary.wind = plan.wind;
    if (hooks.announce) hooks.announce(words_of(plan, integration_));

    const double duration = scene_.as<casefile::TransientAnalysis>().duration;
    const bool blows = warn_of_blows(built_, plan.drives, duration, outcome);
    observe::ProbeHistories probes(probe_nodes(scene_, span.built.model));
    observe::MomentumObserver momentum;
    EnergyHistory energy(scene_.as<casefile::TransientAnalysis>().rows_every);
    ProgressReport progress(duration, hooks);
    std::vector<observe::Observer*> observers = {&probes, &momentum, &energy, &progress};
    std::optional<ClampObserver> clamps;
    if (scene_.clamps && plan.frequency > 0) observers.push_back(&clamps.emplace(scene_, span, plan.frequency));
    if (scene_.clamps && plan.frequency == 0) {
      outcome.warnings.emplace_back(
          "[clamps] counts cycles, and nothing in this run names a frequency: give a harmonic load, [[wind]], or "
          "[initial] velocity_mode");
    }
    std::optional<FieldWriter> fields;
    if (scene_.output) observers.push_back(&fields.emplace(scene_, hooks, plan.frequency));
    solver::IntegratorOptions options = integration_.options(plan.step, duration, plan.drives, plan.frequency);
    options.stop = hooks.stop;
    const solver::IntegratorSummary run =
        solver::integrate(span.system, {.u = span.u, .v = plan.velocity}, options, integration_.method(), observers);

    add_integration(run, span.system, outcome);
    summary.end_time = run.end_time;
    summary.probes = probe_rows(probes, model::arc_lengths(span.built.model));
    summary.momentum = row_of(momentum);
    summary.energy = energy.at_end();
    outcome.tell(summary);
    outcome.findings = findings_of(summary.energy);
    const auto kept = energy.rows().rows();
    add_histories(probes, kept, outcome);
    if (clamps) clamps->add_to({}, outcome);
    if (fields) fields->end(outcome);
    std::vector<EnergyRow> rows;
    for (const auto& [step, row] : kept) rows.push_back(row);
    outcome.tables.push_back({.file = "energies.csv", .table = results::table_of(rows)});
    if (energy.rows().stride() > 1) {
      outcome.findings.push_back(
          fmt::format("Of {} steps one in {} stands in histories.csv and energies.csv; analysis.rows_every_s chooses.",
                      energy.rows().count() - 1, energy.rows().stride()));
    }
    std::vector<std::string> drawn = {"kinetic_J", "elastic_J", "external_work_J"};
    if (!scene_.winds.empty()) drawn.emplace_back("wind_work_J");
    std::ranges::copy(loss_columns(scene_), std::back_inserter(drawn));
    drawn.emplace_back("numerical_dissipation_J");
    outcome.figures.push_back({.name = "energies",
                               .title = "Energies",
                               .table = "energies.csv",
                               .x = "t_s",
                               .y = drawn,
                               .caption = "Energies of the state; works and losses since the start."});
    if (run.ending == solver::Ending::failed) {
      outcome.exit_code = ExitCode::not_converged;
      outcome.message = run.failure;
    } else if (run.ending == solver::Ending::stopped) {
      outcome.exit_code = ExitCode::interrupted;
      outcome.message = fmt::format("interrupted at t = {:.6g} s; what was computed is kept", run.end_time);
    }
    ShareAccount account = energy.account();
    account.stored = stored_by_tension(built_);
    account.has_blows = blows;
    check_numerical_share(scene_, integration_, plan, account, outcome);
  }

 private:
  /// With the loads of the start, unless they come suddenly.
  void stand_ready(span::SpanAtRest& span) const {
    const bool sudden = scene_.as<casefile::TransientAnalysis>().start == casefile::Start::unloaded;
    if (!sudden && is_loaded_at_start(span.built.model)) span.apply_static_loads();
  }

  const Scene& scene_;
  build::Integration integration_;
  build::BuiltSpan built_;
  PlanAsk ask_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_transient() {
  std::vector<results::MemberNote> notes = results::ReferenceWriter::of<TransientSummary>();
  std::ranges::move(ClampObserver::notes(), std::back_inserter(notes));
  std::ranges::move(FieldWriter::notes(), std::back_inserter(notes));
  return notes;
}

std::unique_ptr<Analysis> prepare_transient(const Scene& scene) {
  return std::make_unique<Transient>(scene);
}

}  // namespace strandyn::study
