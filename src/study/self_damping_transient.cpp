#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench_routes.hpp"
#include "self_damping_parts.hpp"
#include "shaken_span.hpp"

namespace strandyn::study {

using casefile::refuse;
using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

void check(const Scene& scene) {
  if (scene.integrator.step == casefile::StepRule::adaptive) {
    refuse(scene.source, "integrator.step", "a test bench counts its cycles in whole steps",
           "use \"fixed\" or \"auto\"");
  }
  const auto check_history = [&](bool table, const char* kind, std::size_t i) {
    if (!table) return;
    refuse(scene.source, fmt::format("{}[{}]", kind, i), "has a history of its own, and a test bench has one shaker",
           "leave it out");
  };
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    check_history(scene.loads[i].type == casefile::LoadType::table, "load", i);
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    check_history(scene.motions[i].type == casefile::MotionType::table, "motion", i);
  }
  shaker_of(scene);
}

void add_ratio(json& out, double power, double reference) {
  if (reference > 0) out["over_ledger"] = power / reference;
}

json ledger_json(const LedgerRoute& route) {
  json out = {{"friction_dissipation_J", route.friction},
              {"viscous_dissipation_J", route.viscous},
              {"numerical_dissipation_J", route.numerical},
              {"quadrature_error_J", route.quadrature_error},
              {"self_damping_W_per_m", route.power}};
  if (route.numerical_share) out["numerical_share"] = *route.numerical_share;
  if (route.friction > 0) out["numerical_over_friction"] = std::abs(route.numerical) / route.friction;
  return out;
}

json power_json(const PowerRoute& route, double reference) {
  json out = {{"self_damping_W_per_m", route.from_phasors}, {"from_work_W_per_m", route.from_work}};
  add_ratio(out, route.from_phasors, reference);
  out["phase_deg"] = route.phase * 180 / std::numbers::pi;
  return out;
}

json iswr_json(const IswrRoute& route) {
  json out = {{"self_damping_W_per_m", route.power}, {"ledger_W_per_m", route.ledger}};
  add_ratio(out, route.power, route.ledger);
  out["by_string_W_per_m"] = route.by_string;
  out["nodes_m"] = {route.near_position, route.far_position};
  out["loops"] = route.loops;
  out["node_amplitudes_m"] = {route.nodes.near.node_amplitude, route.nodes.far.node_amplitude};
  out["antinode_amplitudes_m"] = {route.nodes.near.antinode_amplitude, route.nodes.far.antinode_amplitude};
  out["wave_EI_N_m2"] = route.guide.EI;
  out["wave_tension_N"] = route.guide.tension;
  return out;
}

json decay_json(const DecayRoute& route, double reference) {
  json out = {{"self_damping_W_per_m", route.power}};
  add_ratio(out, route.power, reference);
  out["by_sine_W_per_m"] = route.by_sine;
  out["ledger_W_per_m"] = route.ledger;
  out["decrement"] = route.decrement;
  out["modal_energy_J"] = route.modal_energy;
  out["amplitudes_m"] = route.amplitudes;
  return out;
}

json bench_json(const BenchSpan& bench, const BenchRun& run, const BenchRoutes& routes) {
  json out = {{"mode", bench.mode_number()},
              {"span_length_m", bench.span().built.length},
              {"frequency_Hz", run.steady.drive.frequency},
              {"antinode_amplitude_m", routes.antinode_amplitude},
              {"fundamental_amplitude_m", routes.fundamental_amplitude},
              {bench.moves() ? "shaker_amplitude_m" : "shaker_force_N", run.steady.drive.amplitude},
              {"shaker_at_m", bench.shaker_position()},
              {"tuned_at", run.steady.tuned_at_shaker ? "shaker" : "antinode"},
              {"ledger", ledger_json(routes.ledger)},
              {"power", power_json(routes.power, routes.ledger.power)}};
  if (routes.iswr) out["iswr"] = iswr_json(*routes.iswr);
  if (routes.decay) out["decay"] = decay_json(*routes.decay, routes.ledger.power);
  out["steps_per_cycle"] = run.cost.steps_per_cycle;
  out["cycles_until_steady"] = run.cost.cycles_until_steady;
  out["section_evaluations_until_steady"] = run.cost.evaluations_until_steady;
  out["section_evaluations"] = bench.span().system.effort().evaluations;
  out["steps"] = run.cost.steps;
  return out;
}

/// More of the integrator's own damping than the case allows is no result.
void check_numerical_share(const Scene& scene, const LedgerRoute& ledger) {
  const double bound = scene.integrator.max_numerical_share.value_or(casefile::default_numerical_share);
  if (!ledger.numerical_share || *ledger.numerical_share <= bound) return;
  throw ComputationError(
      fmt::format("the numerical part of the ledger is {:.3g} % of what friction and viscous damping take, above the "
                  "bound of {:.3g} %: give more [integrator] steps_per_cycle, or step = \"auto\"",
                  100 * *ledger.numerical_share, 100 * bound));
}

}  // namespace

Road transient_road(const RoadContext& context) {
  check(context.scene);
  const BenchHooks hooks = {.stop = context.stop, .tell = context.tell};
  return [&scene = context.scene, hooks](const Point& point) -> PointResult {
    BenchSpan bench(scene, point);
    const BenchRun run = run_bench(bench, point.antinode_amplitude, hooks);
    PointResult result{.self_damping = 0, .effort = bench.span().system.effort(), .stopped = run.stopped};
    if (run.stopped) return result;
    const BenchRoutes routes = find_routes(bench, run);
    check_numerical_share(scene, routes.ledger);
    result.self_damping = routes.ledger.power;
    if (routes.iswr) result.free_span = routes.iswr->ledger;
    result.details = {{"bench", bench_json(bench, run, routes)}};
    return result;
  };
}

}  // namespace strandyn::study
