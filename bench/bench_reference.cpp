// The beam by which programs are compared: work dissipated, and the score of the elastic case.
//   cmake --build build/release --target bench_reference && build/release/bench_reference
#include <fmt/format.h>

#include <chrono>
#include <numbers>

#include "reference_beam.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/observe/ledger.hpp"

using namespace strandyn;

namespace {

constexpr double step = 1.0 / 1200;  // [s]
constexpr std::size_t steps = 2000;

void print_hysteretic(const std::string& dimension, int refinement) {
  bench::Span span("benchmark/hysteretic_" + dimension + ".toml", {});
  bench::BendingWork bending;
  observe::Ledger ledger;
  solver::Observer* const observers[] = {&ledger, &bending};
  const auto n = static_cast<std::size_t>(refinement);
  const solver::IntegratorSummary run =
      bench::integrate(span, bench::sine_velocity(span, 12, 0.8), step / refinement, n * steps, observers);
  const observe::Account& a = ledger.now();
  fmt::print("| {} | {} | {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:+.1e} | {:.2f} |\n", dimension, run.steps,
             n, a.initial_kinetic, bending.work(), a.friction, a.elastic, a.kinetic, a.numerical(),
             static_cast<double>(run.newton_iterations) / static_cast<double>(run.steps));
}

struct Score {
  double frequency = 0;  // [Hz] mean over 40 periods
  double seconds = 0;    // of the integration
};

Score elastic(const std::string& dimension, int elements, int steps_per_cycle, bool condensed) {
  constexpr double frequency = 25.676;
  bench::Span span("beam/elastic_benchmark_" + dimension + ".toml",
                   {fmt::format("span.elements={}", elements), "integrator.method=generalized-alpha",
                    "integrator.rho_inf=1", fmt::format("span.condense_axial={}", condensed)});
  const double h = 1 / (frequency * steps_per_cycle);
  observe::ProbeHistories probes({model::nearest_node(span.built.model, 13.8)});
  solver::Observer* const observers[] = {&probes};
  const system::Vector velocity = bench::sine_velocity(span, 12, 0.8);
  const auto start = std::chrono::steady_clock::now();
  bench::integrate(span, velocity, h, static_cast<std::size_t>(41 * steps_per_cycle), observers);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {.frequency = probes.frequency(0).value_or(0), .seconds = time.count()};
}

void print_scores(const std::string& dimension, bool condensed) {
  for (int elements : {24, 30, 36, 40, 50, 60, 100}) {
    for (int n : {24, 32, 48, 64, 96, 128}) {
      const Score s = elastic(dimension, elements, n, condensed);
      fmt::print("| {}{} | {} | {} | {:.4f} | {:+.3f} | {:.4f} |\n", dimension, condensed ? ", condensed" : "",
                 elements, n, s.frequency, 100 * (s.frequency / 25.676 - 1), s.seconds);
    }
  }
}

}  // namespace

int main(int count, char**) {
  fmt::print(
      "Hysteretic: energies in J after 5/3 s\n\n"
      "| case | steps | refinement | initial | M dkappa | friction | stored | kinetic | numerical | corrections a "
      "step |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* dimension : {"planar", "spatial"}) {
    for (int refinement : {1, 2, 4}) print_hysteretic(dimension, refinement);
  }
  if (count > 1) return 0;
  fmt::print(
      "\nElastic: mean frequency over 40 periods\n\n"
      "| case | elements | steps per cycle | frequency Hz | error % | s |\n| --- | --- | --- | --- | --- | --- |\n");
  print_scores("planar", false);
  print_scores("planar", true);
  print_scores("spatial", false);
}
