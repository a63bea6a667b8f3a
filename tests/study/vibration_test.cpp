#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/scenes.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;
using test::span_scene;

namespace {

const std::string shaker =
    "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.5\namplitude_N = 40\nfrequency = \"mode 4\"\n"
    "[analysis]\ntype = \"forced\"\ncycles = 30\n";
const std::string decay = "[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 5\ncycles = 10\n";

}  // namespace

TEST_CASE("the ledger of a forced run closes cycle by cycle") {
  const auto s = test::run(span_scene(shaker)).summary;
  double kinetic = 0;
  double elastic = 0;
  for (const auto& c : s["cycles"]) {
    const double change = c["kinetic_J"].get<double>() - kinetic + c["elastic_J"].get<double>() - elastic;
    const double rest = c["external_work_J"].get<double>() - change - c["friction_dissipation_J"].get<double>() -
                        c["viscous_dissipation_J"].get<double>() - c["numerical_dissipation_J"].get<double>();
    // Rounding of the elastic energy of the tension, some 60 J.
    check_close(rest, 0, {.absolute = 1e-12});
    kinetic = c["kinetic_J"];
    elastic = c["elastic_J"];
  }
  CHECK(s["cycles"].size() == 30);
}

TEST_CASE("the nodal way to elastic energy and friction agrees with the sections' own") {
  const auto s = test::run(span_scene(shaker, {"analysis.cycles=60"})).summary;
  double nodal = 0;
  double sections = s["cycles"].back()["elastic_J"];
  for (const auto& c : s["cycles"]) {
    nodal += c["internal_work_J"].get<double>();
    sections += c["friction_dissipation_J"].get<double>() - c["quadrature_error_J"].get<double>();
  }
  CHECK(sections > 0.1);
  // The trapezoidal rule over a curved motion: second order in the step, 1e-5 at 200 steps per cycle (measured 1e-6).
  check_close(nodal, sections, {.relative = 1e-5});
}

TEST_CASE("drag is booked as viscous dissipation and nothing else") {
  const auto s = test::run(span_scene(decay, {"section.law=stick", "damping.drag_N_s_per_m2=2"})).summary["steady"];
  CHECK(s["friction_dissipation_J"] == 0.0);
  // zeta = c/(2 m omega) of a uniform drag. Its energy is taken as that of a sine of the antinode amplitude; a clamped
  // span flat at its ends has less, 4 % at small swing with 160 elements.
  const double omega = 2 * std::numbers::pi * s["frequency_Hz"].get<double>();
  check_close(s["damping_ratio"], 2 / (2 * 1.981 * omega), {.relative = 0.05});
}

TEST_CASE("a decay starts at the amplitude that was asked for") {
  const auto s = test::run(span_scene(decay, {"section.law=stick", "analysis.antinode_amplitude_mm=0.5"})).summary;
  // It is set by a velocity; the stretch of the span takes some of it, with the square of the amplitude (2.6 % at 5
  // mm).
  check_close(s["cycles"][0]["antinode_amplitude_m"], 5e-4, {.relative = 2e-3});
}

TEST_CASE("a decay starts at that amplitude of the antinodes away from the ends, where an end loop swings wider") {
  const auto scene = span_scene(decay, {"section.law=stick", "analysis.antinode_amplitude_mm=0.1"});
  const auto s = test::run(scene).summary;
  // The stretch goes with the square of the amplitude: 1e-5 here.
  check_close(s["cycles"][0]["antinode_amplitude_m"], 1e-4, {.relative = 3e-5});
  // The shape of the mode, of the same span: next to a clamp its crest is a little higher.
  const auto modes = test::run(span_scene("[analysis]\ntype = \"modes\"\ncount = 4\n", {"section.law=stick"}));
  const auto& shape = modes.tables.front().table;
  const auto& place = shape.column("arc_m");
  const auto& swing = shape.column("mode_4_y");
  double at_the_end = 0, within = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    double& crest = place[i] < 2.5 || place[i] > 7.5 ? at_the_end : within;
    crest = std::max(crest, std::abs(swing[i]));
  }
  CHECK(at_the_end > 1.001 * within);
  CHECK(at_the_end < 1.02 * within);
}

namespace {

/// [W/m] the rows of dissipation_profile.csv summed between two places. Two rows an element, at its Gauss points; each
/// stands for half of the element, on its side of the middle.
double summed_profile(const study::CaseResult& result, double from, double to, double frequency) {
  const auto named = std::ranges::find(result.tables, "dissipation_profile.csv", &results::NamedTable::file);
  REQUIRE(named != result.tables.end());
  const auto& x = named->table.column("x_m");
  const auto& friction = named->table.column("friction_J_per_m");
  const auto& length = named->table.column("length_m");
  double lost = 0;
  for (std::size_t i = 0; i < x.size(); i += 2) {
    const double element = (x[i + 1] - x[i]) * std::sqrt(3.0);
    const double middle = (x[i] + x[i + 1]) / 2;
    for (const std::size_t row : {i, i + 1}) {
      const double low = row == i ? middle - element / 2 : middle;
      const double inside = std::max(0.0, std::min(low + element / 2, to) - std::max(low, from));
      lost += friction[row] * length[row] * inside / (element / 2);
    }
  }
  return lost * frequency / (to - from);
}

void check_free_span(const casefile::Scene& scene) {
  const auto result = test::run(scene);
  const auto& s = result.summary["steady"];
  const double from = s["free_span_from_m"], to = s["free_span_to_m"], free = s["self_damping_free_span_W_per_m"];
  CHECK(free > 0);
  check_close(free, summed_profile(result, from, to, s["frequency_Hz"]), {.relative = 1e-9});
  // The whole of the profile is the friction of the ledger.
  check_close(summed_profile(result, 0, 10, s["frequency_Hz"]) * 10,
              s["friction_dissipation_J"].get<double>() * s["frequency_Hz"].get<double>(), {.relative = 1e-9});
  // A loop at a clamp is longer than one in the span, which is a quarter and less of the four loops.
  CHECK(from > 2.5);
  CHECK(from < 3);
  CHECK(to > 7);
  CHECK(to < 7.5);
}

}  // namespace

TEST_CASE("the free span's self-damping is the profile of the losses summed between the inner nodes") {
  check_free_span(span_scene(decay, {"analysis.antinode_amplitude_mm=12"}));
  check_free_span(span_scene(shaker, {"load[0].amplitude_N=400"}));
}

TEST_CASE("a span of two loops has no free span") {
  const auto s = test::run(span_scene(decay, {"analysis.mode=2", "analysis.cycles=3"})).summary["steady"];
  CHECK_FALSE(s.contains("self_damping_free_span_W_per_m"));
}

TEST_CASE("a decay tells damping against amplitude by its ledger and by its amplitudes") {
  const auto result = test::run(span_scene(decay, {"section.law=stick", "damping.drag_N_s_per_m2=2",
                                                   "analysis.cycles=40", "analysis.antinode_amplitude_mm=1"}));
  const auto& s = result.summary;
  const double zeta = 2 / (2 * 1.981 * 2 * std::numbers::pi * s["steady"]["frequency_Hz"].get<double>());
  REQUIRE(s["decay"]["at"].size() == 5);
  for (const auto& at : s["decay"]["at"]) {
    // A uniform drag: delta = 2 pi zeta at every amplitude. 200 steps a cycle miss a peak by (pi/200)^2/2 at most, 0.6
    // % of the decrement of one cycle.
    check_close(at["log_decrement"], 2 * std::numbers::pi * zeta, {.relative = 6.3e-3});
    check_close(at["loss_factor_by_decrement"], 2 * zeta, {.relative = 6.3e-3});
    check_close(at["loss_factor"], 2 * zeta, {.relative = 0.05});  // energy of a sine; a clamped span has 4 % less
    check_close(at["loss_factor"], 2 * at["damping_ratio"].get<double>(), {.relative = 1e-14});
  }
  check_close(s["decay"]["amplitude_exponent"], 2, {.relative = 1e-3});
  CHECK(s["cycles"][7]["damping_ratio"].get<double>() > 0);
  CHECK(std::ranges::count(result.tables, "decay.csv", &results::NamedTable::file) == 1);
  CHECK_FALSE(s["steady"]["is_steady"].get<bool>());
  CHECK(s["warnings"].empty());  // nobody takes a decay for steady
}

TEST_CASE("an interrupted run keeps its whole cycles") {
  int calls = 0;
  const auto result = test::run(span_scene(shaker), {.stop = [&] { return ++calls > 2500; }, .progress = {}});
  CHECK(result.exit_code == ExitCode::interrupted);
  CHECK(result.summary["status"] == "interrupted");
  // 2500 steps of 200 per cycle; the start takes nine for its first.
  CHECK(result.summary["cycles"].size() == 12);
}

TEST_CASE("a bound on the numerical share that breaks says which step would hold it") {
  const auto result =
      test::run(span_scene(shaker, {"integrator.max_numerical_share=1e-6", "integrator.steps_per_cycle=50"}));
  CHECK(result.exit_code == ExitCode::not_converged);
  CHECK(result.message.find("steps_per_cycle = ") != std::string::npos);
}

TEST_CASE("a run until steady ends when input and loss agree") {
  const auto result =
      test::run(span_scene("[[load]]\ntype = \"harmonic-force\"\nat_m = 0.5\namplitude_N = 40\n"
                           "frequency = \"mode 4\"\n[analysis]\ntype = \"forced\"\nuntil = \"steady\"\n",
                           {"integrator.steps_per_cycle=100", "damping.drag_N_s_per_m2=3"}));
  CHECK(result.exit_code == ExitCode::done);
  const auto& s = result.summary["steady"];
  const double lost = s["friction_dissipation_J"].get<double>() + s["viscous_dissipation_J"].get<double>() +
                      s["numerical_dissipation_J"].get<double>();
  check_close(s["external_work_J"], lost, {.relative = 0.01});
}

TEST_CASE("a static force bends the span along itself and unloads on the way it came while all sticks") {
  const auto s = test::run(span_scene("[[load]]\ntype = \"static-force\"\nat_m = 5\nforce_N = -20\n"
                                      "[analysis]\ntype = \"static\"\nsteps = 4\n"))
                     .summary["steps"];
  REQUIRE(s.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    check_close(s[i]["load_N"], 5.0 * static_cast<double>(i + 1), {.relative = 1e-12});
    // A taut string deflects by F L/(4 T); its bending stiffness takes some of it away.
    const double string = s[i]["load_N"].get<double>() * 10 / (4 * 24420);
    CHECK(s[i]["displacement_m"].get<double>() > 0.8 * string);
    CHECK(s[i]["displacement_m"].get<double>() < string);
  }
}

TEST_CASE("the natural frequencies come in rising order, near those of the taut string") {
  const auto f = test::run(span_scene("[analysis]\ntype = \"modes\"\ncount = 5\n")).summary["frequencies_Hz"];
  REQUIRE(f.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double string = static_cast<double>(i + 1) * std::sqrt(24420 / 1.981) / 20;
    CHECK(f[i].get<double>() > string);
    CHECK(f[i].get<double>() < 1.25 * string);
  }
}

TEST_CASE("what contradicts itself is refused at its key") {
  const std::vector<std::vector<std::string>> pairs = {
      {"integrator.step=adaptive", "integrator.method=generalized-alpha"},
      {"span.condense_axial=true", "span.dimension=spatial"},
      {"span.torsion=false", "span.dimension=spatial", "span.height_difference_m=2"},
      {"damping.rayleigh={mass=0,stiffness=1e-5}", "span.mass=lumped"},
      {"section.law=\"masing\"", "span.dimension=spatial"}};
  for (const std::vector<std::string>& asked : pairs) {
    CAPTURE(asked.front());
    const std::string key = asked.front().substr(0, asked.front().find('='));
    CHECK_THROWS_WITH_AS(test::run(span_scene(shaker, asked)), doctest::Contains(key.c_str()), InputError);
  }
}
