// What a curve of self-damping costs by quadrature, against one cycle of the shaken span of the same conductor.
// Single times depend on the machine and its load; the ratios are of one output.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "strandyn/casefile/read.hpp"
#include "strandyn/study/run_case.hpp"

using namespace strandyn;

namespace {

/// [s] of wall time, the shortest of a few.
double seconds(const std::function<void()>& call, int rounds) {
  double best = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    call();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

std::string list(double first, double last, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("{}{:.6g}", i ? ", " : "", first + (last - first) * i / (count - 1));
  return "[" + text + "]";
}

double curve_time(const std::string& law, const std::string& more) {
  const casefile::Scene scene = casefile::read_scene_text(
      fmt::format(
          "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n[section]\nlaw = \"{}\"\n[span]\nlength_m = 30\n"
          "[analysis]\ntype = \"self-damping\"\nfrequencies_Hz = {}\namplitude_over_diameter = {}\n"
          "tensions_rts = 0.15\n{}",
          law, list(10, 50, 20), list(0.02, 0.4, 25), more),
      "bench.toml");
  return seconds([&] { study::run_case(scene); }, 5);
}

/// [s] of one cycle of the laboratory span, the mean over a run from rest.
double cycle_time(const std::string& law) {
  constexpr int cycles = 40;
  const casefile::Scene scene = casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml",
                                                     {"section.law=" + law, fmt::format("analysis.cycles={}", cycles)});
  return seconds([&] { study::run_case(scene); }, 2) / cycles;
}

}  // namespace

int main() {
  fmt::print("A curve of 500 points, 20 frequencies by 25 amplitudes at one tension, milliseconds;\n");
  fmt::print("one cycle of cases/curlew_lab_span.toml with the same law, its first cycles, when few sections slip.\n");
  fmt::print("{:12} {:>10} {:>14} {:>12} {:>14}\n", "law", "sine", "clamped mode", "one cycle", "cycle/sine");
  for (const std::string law : {"masing", "return-map", "compliant"}) {
    const double sine = curve_time(law, "");
    const double clamped = curve_time(law, "mode_shape = \"clamped\"\n");
    const double cycle = cycle_time(law);
    fmt::print("{:12} {:10.2f} {:14.2f} {:12.2f} {:14.2f}\n", law, 1e3 * sine, 1e3 * clamped, 1e3 * cycle,
               cycle / sine);
  }
}
