#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "integration.hpp"
#include "parts.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/observe/ledger.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

/// Does anything act at time 0 beside the weight? A chain without supports has no stiffness to look for a rest with.
bool is_loaded_at_start(const model::Model& model) {
  const auto acts = [](const auto& source) { return model::evaluate(source.history, 0) != 0; };
  return std::ranges::any_of(model.loads, [&](const model::Load& load) { return !load.dead && acts(load); }) ||
         std::ranges::any_of(model.motions, acts);
}

/// The nodes whose motion is written: where the case says, or the loaded ones and the right end.
std::vector<std::size_t> probe_nodes(const Scene& scene, const model::Model& model) {
  std::vector<double> places = scene.analysis.transient.probes;
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

/// One row per step of the energies and cumulated works.
class EnergyHistory final : public observe::Observer {
 public:
  EnergyHistory()
      : table_({"t_s", "kinetic_J", "elastic_J", "external_work_J", "friction_dissipation_J", "viscous_dissipation_J",
                "numerical_dissipation_J", "quadrature_error_J"}) {}

  void begin(const system::System& system, const observe::StepRecord& initial) override {
    ledger_.begin(system, initial);
    append(initial.time);
  }
  void step(const system::System& system, const observe::StepRecord& record) override {
    ledger_.step(system, record);
    append(record.time);
  }
  bool wants_forces() const override { return true; }
  /// `energy` of summary.json.
  json at_end() const {
    const observe::Account& a = ledger_.now();
    json out;
    for (const std::string& name : table_.names()) {
      if (name != "t_s") out[name] = table_.column(name).back();
    }
    out["initial_kinetic_J"] = a.initial_kinetic;
    out["largest_kinetic_J"] = std::ranges::max(table_.column("kinetic_J"));
    const double lost = a.friction + a.viscous.total();
    if (lost > 0) out["numerical_share"] = std::abs(a.numerical()) / lost;
    return out;
  }
  const results::Table& table() const { return table_; }

 private:
  void append(double time) {
    const observe::Account& a = ledger_.now();
    table_.append(std::array{time, a.kinetic, a.elastic, a.external_work, a.friction, a.viscous.total(), a.numerical(),
                             a.quadrature_error});
  }

  observe::Ledger ledger_;
  results::Table table_;
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

json vector_json(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

void add_probes(const observe::ProbeHistories& probes, const model::Model& model, CaseResult& result) {
  const std::vector<double> arc = model::arc_lengths(model);
  json list = json::array();
  std::vector<std::string> names = {"t_s"};
  for (std::size_t i = 0; i < probes.size(); ++i) {
    json probe = {{"arc_m", arc[probes.node(i)]},
                  {"displacement_m",
                   {{"min", vector_json(probes.lowest(i))},
                    {"max", vector_json(probes.highest(i))},
                    {"end", vector_json(probes.displacements(i).back())}}}};
    if (const auto frequency = probes.frequency(i)) probe["frequency_Hz"] = *frequency;
    list.push_back(probe);
    for (const char* axis : {"x", "y", "z"}) names.push_back(fmt::format("probe_{}_{}_m", i + 1, axis));
  }
  result.summary["probes"] = list;
  results::Table table(names);
  std::vector<double> row;
  for (std::size_t t = 0; t < probes.times().size(); ++t) {
    row = {probes.times()[t]};
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const Eigen::Vector3d& d = probes.displacements(i)[t];
      row.insert(row.end(), d.begin(), d.end());
    }
    table.append(row);
  }
  result.tables.push_back({"histories.csv", std::move(table)});
}

void add_momentum(const observe::MomentumObserver& momentum, CaseResult& result) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (momentum.mass()(axis) > 0) centre(axis) = momentum.momentum()(axis) / momentum.mass()(axis);
  }
  result.summary["momentum"] = {{"linear_kg_m_per_s", vector_json(momentum.momentum())},
                                {"centre_velocity_m_per_s", vector_json(centre)},
                                {"impulse_N_s", vector_json(momentum.impulse())},
                                {"largest_deviation_N_s", momentum.largest_deviation()}};
}

}  // namespace

void run_transient(const Scene& scene, const Hooks& hooks, CaseResult& result) {
  SpanAtRest span(scene);
  add_rest(span, result);
  if (is_loaded_at_start(span.built.model)) span.apply_static_loads();
  const VibrationPlan plan = plan_vibration(scene, span);
  announce(scene, plan, hooks, result);

  const double duration = scene.analysis.transient.duration;
  observe::ProbeHistories probes(probe_nodes(scene, span.built.model));
  observe::MomentumObserver momentum;
  EnergyHistory energy;
  ProgressReport progress(duration, hooks);
  observe::Observer* const observers[] = {&probes, &momentum, &energy, &progress};
  solver::IntegratorOptions options = options_of(scene, plan, duration);
  options.stop = hooks.stop;
  const solver::IntegratorSummary run =
      solver::integrate(span.system, {.u = span.u, .v = plan.velocity}, options, method_of(scene.integrator), observers);

  add_integration(run, span.system, result);
  result.summary["end_time_s"] = run.end_time;
  add_probes(probes, span.built.model, result);
  add_momentum(momentum, result);
  result.summary["energy"] = energy.at_end();
  result.tables.push_back({"energies.csv", energy.table()});
  if (run.ending == solver::Ending::failed) {
    result.exit_code = ExitCode::not_converged;
    result.message = run.failure;
  } else if (run.ending == solver::Ending::stopped) {
    result.exit_code = ExitCode::interrupted;
    result.message = fmt::format("interrupted at t = {:.6g} s; what was computed is kept", run.end_time);
  }
}

}  // namespace strandyn::study
