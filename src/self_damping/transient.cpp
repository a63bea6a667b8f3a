#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "methods.hpp"
#include "strandyn/laboratory/readings.hpp"

namespace strandyn::self_damping {

using casefile::refuse;
using casefile::Scene;
using laboratory::BenchRun;
using laboratory::BenchSpan;
using laboratory::Readings;

namespace {

void check(const Scene& scene) {
  if (scene.integrator.step == casefile::StepRule::adaptive) {
    refuse(scene.source, "integrator.step", "a test bench counts its cycles in whole steps",
           "use \"fixed\" or \"auto\"");
  }
  const auto check_history = [&](const math::TimeFunction& history, const char* kind, std::size_t i) {
    if (std::holds_alternative<math::Constant>(history)) return;
    refuse(scene.source, fmt::format("{}[{}]", kind, i), "has a history of its own, and a test bench has one shaker",
           "leave it out");
  };
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    check_history(scene.loads[i].history_function(), "load", i);
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    check_history(scene.motions[i].history_function(), "motion", i);
  }
  build::shaker_of(scene);
}

std::optional<double> ratio(double power, double reference) {
  return reference > 0 ? std::optional(power / reference) : std::nullopt;
}

LedgerRow row_of(const laboratory::LedgerReading& reading) {
  LedgerRow row{.friction = reading.friction,
                .material = reading.material,
                .viscous = reading.viscous,
                .air = reading.air,
                .numerical = reading.numerical,
                .quadrature_error = reading.quadrature_error,
                .power = reading.power,
                .numerical_share = reading.numerical_share};
  if (reading.friction > 0) row.numerical_over_friction = std::abs(reading.numerical) / reading.friction;
  return row;
}

IswrRow row_of(const laboratory::IswrReading& reading) {
  return {.power = reading.power,
          .ledger = reading.ledger,
          .over_ledger = ratio(reading.power, reading.ledger + reading.air),
          .by_string = reading.by_string,
          .nodes = {reading.near_position, reading.far_position},
          .loops = reading.loops,
          .node_amplitudes = {reading.nodes.near.node_amplitude, reading.nodes.far.node_amplitude},
          .antinode_amplitudes = {reading.nodes.near.antinode_amplitude, reading.nodes.far.antinode_amplitude},
          .wave_EI = reading.guide.EI,
          .wave_tension = reading.guide.tension};
}

DecayRow row_of(const laboratory::DecayReading& reading, double reference) {
  return {.power = reading.power,
          .over_ledger = ratio(reading.power, reference),
          .by_sine = reading.by_sine,
          .ledger = reading.ledger,
          .decrement = reading.decrement,
          .modal_energy = reading.modal_energy,
          .amplitudes = reading.amplitudes};
}

BenchReadings readings_of(const BenchSpan& bench, const BenchRun& run, const Readings& all) {
  BenchReadings out{.mode = bench.mode_number(),
                    .span_length = bench.at_rest().built.length,
                    .frequency = run.steady.drive.frequency,
                    .antinode_amplitude = all.antinode_amplitude,
                    .fundamental_amplitude = all.fundamental_amplitude,
                    .shaker_at = bench.shaker_position(),
                    .tuned_at = run.steady.tuned_at_shaker ? "shaker" : "antinode",
                    .loss_exponent = run.steady.loss_exponent,
                    .ledger = row_of(all.ledger),
                    .power = {.power = all.power.from_phasors,
                              .from_work = all.power.from_work,
                              .over_ledger = ratio(all.power.from_phasors, all.ledger.power + all.ledger.air_power),
                              .phase = all.power.phase * 180 / std::numbers::pi},
                    .steps_per_cycle = run.cost.steps_per_cycle,
                    .cycles_until_steady = run.cost.cycles_until_steady,
                    .evaluations_until_steady = run.cost.evaluations_until_steady,
                    .section_evaluations = bench.at_rest().system.effort().evaluations,
                    .steps = run.cost.steps};
  (bench.moves() ? out.shaker_amplitude : out.shaker_force) = run.steady.drive.amplitude;
  if (all.iswr) out.iswr = row_of(*all.iswr);
  if (all.decay) out.decay = row_of(*all.decay, all.ledger.power + all.ledger.air_power);
  return out;
}

/// More of the integrator's own damping than the case allows is no result.
void check_numerical_share(const Scene& scene, const laboratory::LedgerReading& ledger) {
  const double bound = scene.integrator.max_numerical_share.value_or(casefile::default_numerical_share);
  if (!ledger.numerical_share || *ledger.numerical_share <= bound) return;
  throw ComputationError(
      fmt::format("the numerical part of the ledger is {:.3g} % of all physical losses, above the "
                  "bound of {:.3g} %: give more [integrator] steps_per_cycle, or step = \"auto\"",
                  100 * *ledger.numerical_share, 100 * bound));
}

}  // namespace

TransientMethod::TransientMethod(const Scene& scene) : scene_(scene), integration_(scene) {
  check(scene);
  const casefile::BenchKeys& keys = scene.as<casefile::SelfDampingAnalysis>().bench;
  options_ = {.starts_in_mode = keys.start == casefile::BenchStart::mode,
              .cycles = keys.cycles,
              .decay_cycles = keys.decay_cycles,
              .max_cycles = keys.max_cycles,
              .amplitude_tolerance = keys.amplitude_tolerance};
}

PointResult TransientMethod::at(const Point& point, const Watch& watch) const {
  const Scene own = build::scene_of_point(scene_, point.ask());
  build::BuiltSpan built = build::build_span(own);
  const build::Shaker shaker = build::find_shaker(own, built);
  BenchSpan bench(std::move(built), shaker, build::span_of_point(scene_, point.ask()).mode);
  const BenchRun run = laboratory::run_bench(bench, point.antinode_amplitude, integration_, options_,
                                             {.stop = watch.stop, .tell = watch.tell});
  PointResult result{.effort = bench.at_rest().system.effort(), .stopped = run.stopped};
  if (run.stopped) return result;
  const Readings readings = laboratory::read_all(bench, run);
  check_numerical_share(scene_, readings.ledger);
  result.self_damping = readings.ledger.power;
  const double per_length = run.steady.drive.frequency / bench.at_rest().built.length;
  result.parts = {.friction = readings.ledger.friction * per_length,
                  .material = readings.ledger.material * per_length,
                  .viscous = readings.ledger.viscous * per_length,
                  .air = readings.ledger.air_power};
  if (readings.iswr) {
    result.free_span = readings.iswr->ledger;
    result.parts->air_free_span = readings.iswr->air;
  }
  result.bench = readings_of(bench, run, readings);
  return result;
}

/// Counted on slipping spans: ten to forty periods of the first mode to become steady, and three to six questions to
/// the law a step.
Expected TransientMethod::expected(const std::vector<Point>& points) const {
  Expected expected;
  for (const Point& point : points) {
    const Scene own = build::scene_of_point(scene_, point.ask());
    const build::BuiltSpan built = build::build_span(own);
    build::find_shaker(own, built);
    const int mode = build::span_of_point(scene_, point.ask()).mode;
    build::require_modes(own, built, mode, "analysis.modes");
    const double sections = static_cast<double>(built.section_points());
    const double steps =
        integration_.chooses_steps() ? 400 : 1 / (point.frequency * integration_.step_at(point.frequency));
    const double measured = options_.cycles + options_.decay_cycles;
    expected += {.least = sections * steps * 3.5 * (10 * mode + measured),
                 .most = sections * steps * 6 * (50 * mode + measured)};
  }
  return expected;
}

}  // namespace strandyn::self_damping
