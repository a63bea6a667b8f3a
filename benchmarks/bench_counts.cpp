// One run whose instructions a script counts (tools/measure_instructions):
//   bench_counts CASE STEP_S STEPS ANTINODE_VELOCITY [--set KEY.PATH=VALUE]...
// The case starts as a sine of twelve loops. Prints steps, Newton corrections, tangents, and the
// microseconds of the processor.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <ctime>

#include "measured.hpp"
#include "reference_beam.hpp"

using namespace strandyn;

int main(int count, char** arguments) {
  if (count < 5) {
    fmt::print(stderr, "usage: bench_counts CASE STEP_S STEPS ANTINODE_VELOCITY [--set KEY.PATH=VALUE]...\n");
    return 2;
  }
  std::vector<std::string> overrides;
  for (int i = 5; i < count; ++i) {
    if (std::strcmp(arguments[i], "--set") != 0) overrides.emplace_back(arguments[i]);
  }
  bench::Span span(arguments[1], overrides);
  const double step = std::atof(arguments[2]);
  const auto steps = static_cast<std::size_t>(std::atol(arguments[3]));
  const system::Vector velocity = bench::sine_velocity(span, 12, std::atof(arguments[4]));
  solver::IntegratorSummary run;
  const std::size_t tangents = span.system.jacobian_evaluations();
  const std::clock_t start = std::clock();
  measured([&] { run = bench::integrate(span, velocity, step, steps); });
  if (run.ending != solver::Ending::finished) {
    fmt::print(stderr, "{}\n", run.failure);
    return 3;
  }
  const double microseconds = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  fmt::print("{} {} {} {:.0f}\n", run.steps, run.newton_iterations, span.system.jacobian_evaluations() - tangents,
             microseconds);
}
