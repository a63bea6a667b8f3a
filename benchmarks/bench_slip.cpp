// What a step costs in which nothing slips, and one in which the sections slip, in parts of the same step with the
// linear law `stick`. Nanoseconds depend on the machine; the ratios are of one output.
//   cmake --build build/release --target bench_slip && build/release/bench_slip
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "reference_beam.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/solver/modes/modes.hpp"

using namespace strandyn;

namespace {

constexpr std::size_t first_step = 10, last_step = 40;  // a little more than half a cycle of mode 12

/// Reads the clock of the processor and the counters where the measured steps begin and end.
class Window final : public observe::Observer {
 public:
  void begin(const system::System&, const observe::StepRecord&) override {}
  void step(const system::System& system, const observe::StepRecord&) override {
    ++steps_;
    if (steps_ != first_step && steps_ != last_step) return;
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    const double sign = steps_ == first_step ? -1 : 1;
    seconds += sign * (static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec));
    evaluations += sign * static_cast<double>(system.effort().evaluations);
    sweeps += sign * static_cast<double>(system.effort().sweeps);
    tangents += sign * static_cast<double>(system.jacobian_evaluations());
  }
  double seconds = 0, evaluations = 0, sweeps = 0, tangents = 0;

 private:
  std::size_t steps_ = 0;
};

struct Case {
  std::string dimension, method, law;
  double velocity = 0;  // [m/s] of the antinodes
};

Window run(const Case& c) {
  Window best;
  best.seconds = 1e9;
  for (int round = 0; round < 15; ++round) {
    bench::Span span("curlew_lab_span.toml", {"load[0].amplitude_N=0", "span.dimension=" + c.dimension,
                                              "integrator.method=" + c.method, "section.law=" + c.law});
    Window window;
    observe::Observer* const observers[] = {&window};
    const solver::Mode mode = solver::transverse_modes(span.system, span.u, 12).back();
    const system::Vector velocity = c.velocity * mode.shape / mode.shape.cwiseAbs().maxCoeff();
    bench::integrate(span, velocity, 2.05e-4, last_step, observers);
    if (window.seconds < best.seconds) best = window;
  }
  return best;
}

}  // namespace

int main() {
  constexpr double steps = last_step - first_step;
  constexpr double omega = 153;  // [1/s] of mode 12
  fmt::print("Curlew, 30 m, mode 12, 80 elements, 36 points; {} lanes\n\n", section::vector_target().lanes);
  fmt::print(
      "| dimension | method | antinode mm | law | us a step | of stick | law asked | tangents | sections slipping |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string dimension : {"planar", "spatial"}) {
    for (const std::string method : {"ida", "generalized-alpha"}) {
      for (const double velocity : {1.5e-5, 3.0, 8.0}) {
        double stick = 0;
        for (const std::string law : {"stick", "return-map"}) {
          const Window w = run({dimension, method, law, velocity});
          if (law == "stick") stick = w.seconds;
          const double points = 160;
          fmt::print("| {} | {} | {:.3g} | {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} % |\n", dimension, method,
                     1e3 * velocity / omega, law, 1e6 * w.seconds / steps, w.seconds / stick,
                     w.evaluations / points / steps, w.tangents / steps, 100 * w.sweeps / w.evaluations);
        }
      }
    }
  }
}
