// How a run begins: with a blow or eased in, loaded or at rest; and what its own account is held against.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/casefile/read.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;

namespace {

test::Run run(const std::string& text) {
  return test::run(casefile::read_scene_text(text, "test.toml"));
}

bool warns(const test::Run& run, const std::string& words) {
  return std::ranges::any_of(run.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// Samples of 2 mm sin(2 pi 20 t), every 4 ms, at the left clamp of a frictional span.
std::string sampled(const std::string& more, double step, const char* method) {
  std::string rows;
  for (int i = 0; i <= 50; ++i) {
    const double t = 0.004 * i;
    rows += fmt::format("{}[{}, {}]", i ? "," : "", t, 2 * std::sin(2 * std::numbers::pi * 20 * t));
  }
  return fmt::format(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n"
      "[span]\nlength_m = 10\ntension_rts = 0.15\nelements = 40\n"
      "[[motion]]\ntype = \"table\"\nat = \"left\"\n{}history = [{}]\n"
      "[integrator]\nmethod = \"{}\"\nstep_s = {}\n[analysis]\ntype = \"transient\"\nduration_s = 0.2\n",
      more, rows, method, step);
}

std::string pushed(const std::string& start) {
  return "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 0.01\nmass_kg_per_m = 1\n"
         "[span]\nlength_m = 20\ntension_kN = 10\nelements = 40\nleft = \"pinned\"\nright = \"pinned\"\n"
         "[[load]]\ntype = \"table\"\nat_m = 10\nhistory = [[0, 10], [1, 10]]\n"
         "[integrator]\nstep_s = 2e-4\n[analysis]\ntype = \"transient\"\nduration_s = 0.2\nprobes_m = [5]\n" +
         start;
}

std::string decay(const std::string& law, const std::string& integrator, int cycles) {
  return law + "[span]\nlength_m = 10\ntension_kN = 20\nelements = 40\n[integrator]\n" + integrator +
         fmt::format("[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 4\ncycles = {}\n", cycles);
}
const std::string curlew = "[conductor]\ncatalogue = \"curlew\"\n";
const std::string elastic = "[section]\nlaw = \"elastic\"\nEA_N = 4e7\nEI_N_m2 = 100\nmass_kg_per_m = 2\n";

}  // namespace

TEST_CASE("a sampled motion that is eased in loses the same with any step and method") {
  const std::string eased = "ease_s = 0.1\n";
  const auto friction = [&](double step, const char* method) {
    const auto r = run(sampled(eased, step, method));
    CHECK(r.exit_code == ExitCode::done);
    CHECK(!warns(r, "jumps by"));
    return r.summary["energy"]["friction_dissipation_J"].get<double>();
  };
  const double fine = friction(3e-5, "generalized-alpha");
  CHECK(fine > 0);
  for (const char* method : {"ida", "generalized-alpha"}) {
    check_close(friction(1.2e-4, method), fine, {.relative = 1e-2});
  }
}

TEST_CASE("a motion whose velocity jumps is warned of with the jump") {
  const auto start = run(sampled("", 1e-3, "generalized-alpha"));
  // 2 pi 20 Hz times 2 mm = 0.2513 m/s at the start; the curve through twelve points a period has it within 2 %.
  CHECK(warns(start, "jumps by 0.25"));
  const auto corners = run(sampled("interpolation = \"linear\"\nease_s = 0.1\n", 1e-3, "generalized-alpha"));
  CHECK(warns(corners, "jumps by"));
}

TEST_CASE("a force that a table has at once belongs to the rest, or comes suddenly where the case says so") {
  const auto silent = run(pushed(""));
  CHECK(silent.exit_code == ExitCode::done);
  CHECK(warns(silent, "belongs to the state of rest"));
  CHECK(std::abs(silent.summary["probes"][0]["displacement_m"]["max"][1].get<double>()) < 1e-9);
  CHECK(!warns(run(pushed("start = \"loaded\"\n")), "belongs to the state of rest"));
  // A string struck by a step force P at its middle: waves at c = 100 m/s lift each place by P x/(2 T) when they pass;
  // at 5 m the wave comes after 0.05 s, its mirror of the support after 0.15 s. In between P c (t - 0.05)/(2 T).
  const auto sudden = run(pushed("start = \"unloaded\"\n"));
  CHECK(sudden.exit_code == ExitCode::done);
  const double greatest = sudden.summary["probes"][0]["displacement_m"]["max"][1];
  check_close(greatest, 10.0 * 100 * 0.1 / (2 * 10e3), {.relative = 0.02});
}

TEST_CASE("numerical part: a few coarse cycles end with advice that holds when it is followed") {
  const auto coarse = run(decay(curlew, "step_s = 1\n", 19));
  CHECK(coarse.exit_code == ExitCode::not_converged);
  REQUIRE(coarse.message.find("steps_per_cycle = 200") != std::string::npos);
  CHECK(run(decay(curlew, "steps_per_cycle = 200\n", 19)).exit_code == ExitCode::done);
}

TEST_CASE("numerical part: a frictionless run is bound by its energy") {
  const auto coarse = run(decay(elastic, "steps_per_cycle = 12\n", 5));
  CHECK(coarse.exit_code == ExitCode::not_converged);
  CHECK(coarse.message.find("of the greatest energy") != std::string::npos);
  CHECK(run(decay(elastic, "", 5)).exit_code == ExitCode::done);
}

TEST_CASE("numerical part: a blow that creates energy ends the run and says that no step holds it") {
  const auto r =
      run("[conductor]\ncatalogue = \"curlew\"\n[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 30\n"
          "[[motion]]\ntype = \"table\"\nat = \"left\"\nhistory = [[0,0],[0.05,0],[0.05001,10],[0.2,10]]\n"
          "[integrator]\nstep_s = 5e-4\n[analysis]\ntype = \"transient\"\nduration_s = 0.2\n");
  CHECK(r.exit_code == ExitCode::not_converged);
  CHECK(r.message.find("ease the motion in") != std::string::npos);
  CHECK(warns(r, "jumps by 1000 m/s"));
}

TEST_CASE("a step that cannot be taken ends the run with time, step and unknowns, by either method") {
  for (const char* method : {"ida", "generalized-alpha"}) {
    CAPTURE(method);
    const auto r =
        run("[conductor]\ncatalogue = \"curlew\"\n[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 30\n"
            "[integrator]\nmethod = \"" +
            std::string(method) +
            "\"\n[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 10000\ncycles = 3\n");
    CHECK(r.exit_code == ExitCode::not_converged);
    CHECK(r.message.find("did not converge") != std::string::npos);
    CHECK(r.message.find("node") != std::string::npos);
  }
}
