// What a section point, an element and each part of a step cost, in nanoseconds and in shares of one run.
// Single times depend on the machine and its load; compare the rows of one output with each other.
#include <fmt/format.h>

#include <chrono>
#include <string>

#include "strandyn/build/span.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "timing.hpp"

using namespace strandyn;
using bench::seconds_per_call;
using section::Dimension;

namespace {

casefile::Scene scene_with(const std::vector<std::string>& overrides) {
  return casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml", overrides);
}

void print_law(const std::string& name, const std::string& law, int section_points, double curvature) {
  const casefile::Scene scene =
      scene_with({fmt::format("section.law={}", law), fmt::format("section.points={}", section_points)});
  const double strain = *casefile::span_tension(scene) / build::section_numbers(scene).EA;
  const bench::LawTimes t =
      bench::time_law(*build::build_law(scene, Dimension::planar), {.eps = strain, .chi2 = curvature, .chi3 = 0});
  fmt::print("{:34} {:10.2f} {:14.2f} {:10.2f}\n", name, 1e9 * t.response, 1e9 * t.with_tangent, 1e9 * t.commit);
}

void print_laws() {
  fmt::print("Section point, Curlew at 15 % RTS, batches of {}: nanoseconds per point\n", bench::law_batch);
  fmt::print("{:34} {:>10} {:>14} {:>10}\n", "law", "response", "with tangent", "commit");
  print_law("stick", "stick", 36, 0.02);
  print_law("return-map, 36 points, no slip", "return-map", 36, 1e-6);
  for (int points : {20, 36, 72}) {
    print_law(fmt::format("return-map, {} points, slipping", points), "return-map", points, 0.05);
  }
  print_law("masing, slipping", "masing", 36, 0.05);
}

void print_elements() {
  fmt::print("\nElement, stick law (section included): nanoseconds per element\n");
  const casefile::Scene scene = scene_with({"section.law=stick"});
  const build::BuiltSpan built = build::build_span(scene);
  system::System system(built.model);
  system::Vector u = system::Vector::Zero(static_cast<Eigen::Index>(system.unknowns()));
  system.begin(u);
  system::Vector f(u.size());
  system::Matrix K = system.make_matrix();
  const double per_element = 1e9 / static_cast<double>(built.model.elements.size());
  fmt::print("residual {:.1f}, with tangent {:.1f}\n",
             per_element * seconds_per_call([&] { system.internal_force(u.data(), f.data()); }),
             per_element * seconds_per_call([&] { system.internal_force(u.data(), f.data(), K); }));
}

/// [Hz] of the mode at which the span is shaken; the same in space.
double planar_frequency() {
  const build::BuiltSpan built = build::build_span(scene_with({}));
  system::System system(built.model);
  const system::Vector u = system.make_vector();
  system.begin(u);
  return solver::transverse_modes(system, u, 12).back().frequency;
}

void print_shares(const std::string& law, const std::string& dimension, const std::string& method, double frequency) {
  constexpr int cycles = 20;
  const casefile::Scene scene = scene_with(
      {"section.law=" + law, "span.dimension=" + dimension, "integrator.method=" + method, "load[0].amplitude_N=150"});
  const build::BuiltSpan built = build::build_span(scene);
  system::System system(built.model);
  const system::Vector u = system.make_vector();
  system.begin(u);
  observe::CycleObserver observer({.period = 1 / frequency, .loop_length = built.length / 12});
  observe::Observer* const observers[] = {&observer};
  const solver::InitialMotion initial{.u = u, .v = system.make_vector()};
  const solver::IntegratorOptions options{
      .step = 1 / (200 * frequency), .end_time = cycles / frequency, .stop = {}, .drives = {{.frequency = frequency}}};
  system.stopwatch().enabled = true;
  const auto start = std::chrono::steady_clock::now();
  const solver::TimeMethod chosen = scene.integrator.method == casefile::Method::ida
                                        ? solver::TimeMethod(solver::Ida{})
                                        : solver::GeneralizedAlpha{.rho_inf = scene.integrator.rho_inf};
  const solver::IntegratorSummary run = solver::integrate(system, initial, options, chosen, observers);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const double steps = static_cast<double>(run.steps);
  fmt::print(
      "\nRun of {} cycles, {} {}, {}: {:.1f} us a step; a step has {:.2f} residuals, {:.2f} tangents, {:.2f} "
      "corrections\n",
      cycles, dimension, law, method, 1e6 * wall.count() / steps,
      static_cast<double>(system.residual_evaluations()) / steps,
      static_cast<double>(system.jacobian_evaluations()) / steps, static_cast<double>(run.newton_iterations) / steps);
  double rest = wall.count();
  for (std::size_t part = 0; part < part_count; ++part) {
    const double seconds = system.stopwatch().seconds[part];
    fmt::print("  {:14} {:5.1f} %\n", part_names[part], 100 * seconds / wall.count());
    // The observers evaluate forces themselves: their time contains some of the parts above.
    if (Part{part} != Part::observers) rest -= seconds;
  }
  fmt::print("  {:14} {:5.1f} % (the integrator's own work on vectors)\n", "rest", 100 * rest / wall.count());
}

}  // namespace

int main() {
  const section::VectorTarget target = section::vector_target();
  fmt::print("vector instructions: {} ({} doubles)\n\n", target.name, target.lanes);
  print_laws();
  print_elements();
  const double frequency = planar_frequency();
  for (const char* dimension : {"planar", "spatial"}) {
    for (const char* method : {"ida", "generalized-alpha"}) {
      for (const char* law : {"stick", "return-map"}) print_shares(law, dimension, method, frequency);
    }
  }
}
