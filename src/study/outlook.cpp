#include "outlook.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

#include "strandyn/observe/cycles.hpp"

namespace strandyn::study {

namespace {

struct SpanFacts {
  double length = 0, tension = 0, unstressed_length = 0, mass = 0, rotary = 0;
  std::optional<double> wave_speed{};
};
template <class V>
void members(V& v, SpanFacts& s) {
  v.value("length_m", s.length, {.what = "between the supports"});
  v.value("tension_N", s.tension, {.what = "at rest; the horizontal component where it hangs"});
  v.value("unstressed_length_m", s.unstressed_length, {.what = "without tension"});
  v.value("mass_kg_per_m", s.mass, {.what = "of unstressed length"});
  v.value("rotary_inertia_kg_m", s.rotary, {.what = "of the section, where it counts"});
  v.value("wave_speed_m_per_s", s.wave_speed, {.what = "by tension and mass"});
}

struct MeshFacts {
  std::size_t elements = 0, unknowns = 0, section_points = 0;
  double shortest = 0, longest = 0;
  std::optional<double> all_slipping{}, all_sticking{};
};
template <class V>
void members(V& v, MeshFacts& m) {
  v.value("elements", m.elements, {.what = "of the chain"});
  v.value("unknowns", m.unknowns, {.what = "of all nodes"});
  v.value("section_points", m.section_points, {.what = "two per element"});
  v.value("shortest_element_m", m.shortest, {.what = "at a clamp"});
  v.value("longest_element_m", m.longest, {.what = "in the span"});
  v.value("boundary_layer_all_slipping_m", m.all_slipping, {.what = "sqrt(EI_min/T)"});
  v.value("boundary_layer_all_sticking_m", m.all_sticking, {.what = "sqrt(EI_max/T)"});
}

struct VibrationFacts {
  PlanRow plan;
  std::size_t cycles = 0;
  bool until_steady = false;
  double loop_length = 0;
  std::optional<double> amplitude{};
  double friction = 0;
};
template <class V>
void members(V& v, VibrationFacts& f) {
  v.part(f.plan);
  v.value("cycles", f.cycles, {.what = "the most that will be run"});
  v.value("until_steady", f.until_steady, {.what = "whether it may end before"});
  v.value("loop_length_m", f.loop_length, {.what = "half a wave"});
  v.value("expected_amplitude_m", f.amplitude, {.what = "of the antinode, by trial cycles"});
  v.value("friction_of_half_a_cycle_J", f.friction, {.what = "at that amplitude, by a trial"});
}

/// Ends an integration after a time [s] and counts its steps.
struct Trial {
  double steps = 0, evaluations = 0, seconds = 0;
  double friction = 0;  // [J]
};

Trial try_steps(double end_time, const system::Vector& velocity, const VibrationPlan& plan,
                const build::Integration& integration, span::SpanAtRest& span) {
  constexpr double most_seconds = 0.5;
  solver::IntegratorOptions options = integration.options(plan.step, end_time, plan.drives, plan.frequency);
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  options.stop = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > most_seconds;
  };
  const auto before = span.system.effort().evaluations;
  observe::CycleObserver ledger({.period = end_time, .loop_length = 0});
  observe::Observer* const observers[] = {&ledger};
  const solver::IntegratorSummary run =
      solver::integrate(span.system, {.u = span.u, .v = velocity}, options, integration.method(), observers);
  return {.steps = static_cast<double>(std::max<std::size_t>(1, run.steps)),
          .evaluations = static_cast<double>(span.system.effort().evaluations - before),
          .seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC,
          .friction = ledger.cycles().empty() ? 0 : ledger.cycles().front().friction};
}

void expect_steps(double least, double most, const Trial& trial, Outlook& outlook) {
  const double per_step = trial.evaluations / trial.steps;
  outlook.evaluations_least = least * per_step / 1.6;
  outlook.evaluations_most = most * per_step * 1.6;
  outlook.seconds_per_evaluation = trial.seconds / std::max(1.0, trial.evaluations);
  outlook.memory = memory_in_use();
}

}  // namespace

void expect(Outlook& outlook, double evaluations, double within) {
  outlook.evaluations_least = evaluations / within;
  outlook.evaluations_most = evaluations * within;
  outlook.memory = memory_in_use();
}

double memory_in_use() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double evaluation_time(const span::SpanAtRest& span) {
  system::Vector force(span.u.size());
  double best = 1;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    span.system.internal_force(span.u.data(), force.data());
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return best / static_cast<double>(span.built.section_points());
}

double slipping_time(const section::Law& law, std::size_t points, const SlippingCycle& cycle) {
  constexpr double most_seconds = 0.1;
  section::Field strains(law.dimension(), points);
  section::Field stresses(law.dimension(), points);
  section::TangentField tangents(law.dimension(), points);
  section::StepEnergy energy(points);
  std::ranges::fill(strains[section::Component::axial], cycle.axial_strain);
  section::History history = law.start(strains);
  const std::clock_t start = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  int step = 0;
  while (step < cycle.steps && seconds() < most_seconds) {
    ++step;
    std::ranges::fill(strains[section::Component::bending2],
                      cycle.amplitude * std::sin(2 * std::numbers::pi * step / cycle.steps));
    law.commit(history, strains, energy);
    law.respond(history, strains, stresses, cycle.tangents ? &tangents : nullptr);
  }
  return seconds() / static_cast<double>(2 * step) / static_cast<double>(points);
}

void add_span(const build::BuiltSpan& span, Outlook& outlook) {
  SpanFacts facts{.length = span.length,
                  .tension = span.tension,
                  .unstressed_length = span.model.unstressed_length(),
                  .mass = span.model.inertia.mass,
                  .rotary = span.model.inertia.rotary};
  if (span.model.inertia.mass > 0) facts.wave_speed = span.wave_speed();
  outlook.tell("span", facts);
  MeshFacts mesh{.elements = span.model.elements.size(),
                 .unknowns = span.model.unknowns(),
                 .section_points = span.section_points(),
                 .shortest = span.length,
                 .longest = 0};
  for (const beam::SpatialElement& element : span.model.elements) {
    mesh.shortest = std::min(mesh.shortest, element.span.norm());
    mesh.longest = std::max(mesh.longest, element.span.norm());
  }
  if (span.tension > 0) {
    mesh.all_slipping = std::sqrt(span.numbers.EI_min / span.tension);
    mesh.all_sticking = std::sqrt(span.numbers.EI_max / span.tension);
  }
  outlook.tell("mesh", mesh);
}

void add_vibration(const casefile::Scene& scene, const VibrationPlan& plan, const build::Integration& integration,
                   span::SpanAtRest& span, Outlook& outlook) {
  VibrationFacts facts{.plan = row_of(plan),
                       .cycles = plan.cycles,
                       .until_steady = plan.until_steady,
                       .loop_length = span.built.loop_length(plan.frequency)};
  const double amplitude = expected_amplitude(plan, span);
  if (amplitude > 0) facts.amplitude = amplitude;
  system::Vector velocity = plan.velocity;
  if (amplitude > 0) velocity = 2 * std::numbers::pi * plan.frequency * amplitude * plan.shape;
  Trial trial = try_steps(0.5 / plan.frequency, velocity, plan, integration, span);
  facts.friction = trial.friction;
  outlook.tell("vibration", facts);
  // What the first steps take is mostly what there is but once.
  constexpr double short_time = 0.1;  // [s]
  constexpr double cycles = 3;
  // The arms of dampers would go on from where the first trial left them.
  if (trial.seconds < short_time && scene.dampers.empty()) {
    const Trial longer = try_steps(cycles / plan.frequency, velocity, plan, integration, span);
    trial.seconds = longer.seconds / longer.evaluations * trial.evaluations;
  }
  const double most = static_cast<double>(plan.cycles) * plan.steps_per_cycle();
  // Until it is steady: between some time constants of the damping and as many as are allowed.
  const double least = plan.until_steady ? std::max(most / 6, 40 * plan.steps_per_cycle()) : most;
  expect_steps(least, most, trial, outlook);
}

void add_steps(double steps, const VibrationPlan& plan, const build::Integration& integration, span::SpanAtRest& span,
               Outlook& outlook) {
  outlook.tell("integration", row_of(plan));
  const Trial trial = try_steps(std::min(steps, 100.0) * plan.step, plan.velocity, plan, integration, span);
  expect_steps(steps, steps, trial, outlook);
}

}  // namespace strandyn::study
