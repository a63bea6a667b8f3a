#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "checkpoint.hpp"
#include "integration.hpp"
#include "parts.hpp"
#include "strandyn/analysis/steady.hpp"
#include "strandyn/observe/cycles.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;
using observe::Cycle;

namespace {

/// The columns of cycles.csv and the keys of summary.cycles, in one order.
json cycle_json(const Cycle& c) {
  return {{"t_s", c.end_time},
          {"antinode_amplitude_m", c.antinode_amplitude},
          {"external_work_J", c.external_work},
          {"kinetic_J", c.kinetic},
          {"elastic_J", c.elastic},
          {"friction_dissipation_J", c.friction},
          {"viscous_dissipation_J", c.viscous},
          {"drag_J", c.viscous_parts.drag},
          {"dampers_J", c.viscous_parts.dampers},
          {"rayleigh_J", c.viscous_parts.rayleigh},
          {"modal_J", c.viscous_parts.modal},
          {"numerical_dissipation_J", c.numerical},
          {"quadrature_error_J", c.quadrature_error},
          {"internal_work_J", c.internal_work},
          {"elements_slipping", c.elements_slipping}};
}

void add_cycles(const std::vector<Cycle>& cycles, CaseResult& result) {
  std::vector<std::string> names = {"cycle"};
  const json keys = cycle_json({});
  for (const auto& [key, value] : keys.items()) names.push_back(key);
  results::Table table(names);
  json list = json::array();
  for (const Cycle& cycle : cycles) {
    const json entry = cycle_json(cycle);
    std::vector<double> row = {static_cast<double>(list.size() + 1)};
    for (const auto& [key, value] : entry.items()) row.push_back(value.get<double>());
    table.append(row);
    list.push_back(entry);
  }
  result.summary["cycles"] = list;
  result.tables.push_back({"cycles.csv", std::move(table)});
}

void add_steady(const Scene& scene, const VibrationPlan& plan, const std::vector<Cycle>& cycles, CaseResult& result) {
  std::vector<analysis::CycleLosses> losses;
  for (const Cycle& c : cycles) losses.push_back({c.antinode_amplitude, c.friction, c.viscous, c.numerical});
  const analysis::SteadyState s =
      analysis::steady_state(losses, {.frequency = plan.frequency,
                                      .length = scene.span->total_length(),
                                      .mass_per_length = *casefile::mass_per_length(scene)});
  if (s.cycles == 0) return;
  // Means of what a cycle lists, over the same cycles.
  json mean = cycle_json({});
  for (const auto& [key, value] : mean.items()) {
    double sum = 0;
    for (std::size_t i = cycles.size() - s.cycles; i < cycles.size(); ++i)
      sum += result.summary["cycles"][i][key].get<double>();
    mean[key] = sum / static_cast<double>(s.cycles);
  }
  mean["t_s"] = cycles.back().end_time;
  json& steady = result.summary["steady"] = json{{"cycles", s.cycles}, {"frequency_Hz", plan.frequency}};
  steady.update(mean);
  steady["self_damping_W_per_m"] = s.self_damping;
  steady["loss_factor"] = s.loss_factor;
  steady["damping_ratio"] = s.damping_ratio;
  if (s.numerical_share) steady["numerical_share"] = *s.numerical_share;
  steady["steps_per_cycle"] = plan.steps_per_cycle();
  if (plan.numerical_damping_ratio) steady["predicted_numerical_damping_ratio"] = *plan.numerical_damping_ratio;
  const double energy = steady["kinetic_J"].get<double>() + steady["elastic_J"].get<double>();
  if (energy > 0) {
    steady["measured_numerical_damping_ratio"] =
        steady["numerical_dissipation_J"].get<double>() / (4 * std::numbers::pi * energy);
  }
  if (plan.expected_damping_ratio) steady["expected_damping_ratio"] = *plan.expected_damping_ratio;
}

void add_profile(const observe::Profile& profile, CaseResult& result) {
  results::Table table({"x_m", "friction_J_per_m", "curvature_amplitude_per_m"});
  for (std::size_t i = 0; i < profile.position.size(); ++i) {
    table.append(std::array{profile.position[i], profile.friction[i], profile.curvature_amplitude[i]});
  }
  result.tables.push_back({"dissipation_profile.csv", std::move(table)});
}

/// Twenty cycles of like amplitude, in which what comes in is what is lost.
bool is_steady(const std::vector<Cycle>& cycles) {
  constexpr std::size_t watched = 20;
  if (cycles.size() < 2 * watched) return false;
  double low = cycles.back().antinode_amplitude;
  double high = low;
  double in = 0;
  double lost = 0;
  for (std::size_t i = cycles.size() - watched; i < cycles.size(); ++i) {
    low = std::min(low, cycles[i].antinode_amplitude);
    high = std::max(high, cycles[i].antinode_amplitude);
    in += cycles[i].external_work;
    lost += cycles[i].friction + cycles[i].viscous + cycles[i].numerical;
  }
  return high - low <= 2e-3 * high && std::abs(in - lost) <= 5e-3 * std::abs(in);
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
                                                   cycles_.cycles().size(), plan_.cycles, 1e3 * amplitude));
  }

 private:
  const VibrationPlan& plan_;
  const Hooks& hooks_;
  const observe::CycleObserver& cycles_;
};

/// A wave wants some elements: with fewer than four a loop, frequencies and losses are the mesh's own.
void warn_of_coarse_mesh(const SpanAtRest& span, double loop_length, CaseResult& result) {
  constexpr double least_per_loop = 4;
  double longest = 0;
  for (const beam::SpatialElement& element : span.built.model.elements) longest = std::max(longest, element.length);
  if (longest * least_per_loop <= loop_length) return;
  result.summary["warnings"].push_back(fmt::format(
      "the longest element, {:.3g} m, is more than 1/4 of a loop ({:.3g} m): give more [span] elements, or \"auto\"",
      longest, loop_length));
}

}  // namespace

void add_integration(const solver::IntegratorSummary& run, const system::System& system, CaseResult& result) {
  json& cost = result.summary["cost"];
  cost["steps"] = run.steps;
  cost["rejected_steps"] = run.rejected_steps;
  cost["order_one_steps"] = run.order_one_steps;
  cost["newton_iterations"] = run.newton_iterations;
  add_effort(system, cost);
  if (run.order_one_steps > 0) {
    result.summary["warnings"].push_back(fmt::format(
        "{} steps fell back to order 1, which damps strongly: the numerical part shows how much", run.order_one_steps));
  }
}

void run_vibration(const Scene& scene, const Hooks& hooks, CaseResult& result) {
  CheckpointFile checkpoint(scene, hooks);
  SpanAtRest span(scene);
  add_rest(span, result);
  span.apply_static_loads();
  const VibrationPlan plan = plan_vibration(scene, span);
  announce(scene, plan, hooks, result);

  const double loop_length = build::loop_length(scene, span.built.tension, plan.frequency);
  warn_of_coarse_mesh(span, loop_length, result);
  observe::CycleObserver cycles({.period = 1 / plan.frequency, .loop_length = loop_length});
  ProgressReport progress(plan, hooks, cycles);
  observe::Observer* const observers[] = {&cycles, &progress};
  bool interrupted = false;
  bool steady = false;
  std::size_t judged = 0;
  const auto stop = [&] {
    if (plan.until_steady && cycles.cycles().size() > judged) {
      judged = cycles.cycles().size();
      steady = is_steady(cycles.cycles());
    }
    interrupted = !steady && hooks.stop && hooks.stop();  // a steady run has come to its end
    return interrupted || steady;
  };
  solver::IntegratorOptions options = options_of(scene, plan, static_cast<double>(plan.cycles) / plan.frequency);
  options.stop = stop;
  options.checkpoints = checkpoint.checkpoints([&] { return interrupted; });
  const solver::IntegratorSummary run =
      solver::integrate(span.system, {.u = span.u, .v = plan.velocity}, options, method_of(scene.integrator), observers);

  add_integration(run, span.system, result);
  add_cycles(cycles.cycles(), result);
  add_steady(scene, plan, cycles.cycles(), result);
  add_profile(cycles.profile(span.system), result);
  result.ended_early = interrupted || run.ending == solver::Ending::failed;
  if (run.ending == solver::Ending::failed) {
    result.exit_code = ExitCode::not_converged;
    result.message = run.failure;
  } else if (interrupted) {
    result.exit_code = ExitCode::interrupted;
    result.message = fmt::format("interrupted at t = {:.6g} s after {} whole cycles; what was computed is kept",
                                 run.end_time, cycles.cycles().size());
  } else if (plan.until_steady && !steady) {
    result.exit_code = ExitCode::not_converged;
    result.message = fmt::format("not steady after {} cycles; give [analysis] cycles, or a stronger damping",
                                 cycles.cycles().size());
  }
}

}  // namespace strandyn::study
