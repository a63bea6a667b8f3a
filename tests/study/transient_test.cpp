#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "study/scenes.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;

namespace {

/// A free elastic bar in the plane, pushed across at its middle for 0.1 s; more lines and tables follow.
casefile::Scene free_bar(const std::string& tables, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[section]\nlaw = \"elastic\"\nEA_N = 1e4\nEI_N_m2 = 100\nmass_kg_per_m = 2\n"
      "[span]\nlength_m = 4\ntension_kN = 0\nelements = 8\nleft = \"free\"\nright = \"free\"\n"
      "[[load]]\ntype = \"table\"\nat_m = 2\nhistory = [[0, 0], [0.05, 30], [0.1, 0]]\n"
      "[analysis]\ntype = \"transient\"\n" +
          tables,
      "test.toml", overrides);
}

const std::string duration = "duration_s = 0.4\n[integrator]\nstep_s = 1e-3\n";

/// A taut clamped span that starts in a mode.
casefile::Scene taut_span(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 10\nmass_kg_per_m = 1\n"
      "[span]\nlength_m = 10\ntension_kN = 4\nelements = 40\nmass = \"consistent\"\n"
      "[initial]\nvelocity_mode = 2\nantinode_velocity_m_per_s = 0.01\n"
      "[analysis]\ntype = \"transient\"\nduration_s = 1.5\nprobes_m = [2.5, 7.5]\n"
      "[integrator]\nstep_s = 5e-4\n" +
          more,
      "test.toml", overrides);
}

}  // namespace

TEST_CASE("a free bar keeps the momentum that the force has given it") {
  const auto s = test::run(free_bar(duration)).summary;
  const double impulse = 0.5 * 0.1 * 30;
  check_close(s["momentum"]["impulse_N_s"][1], impulse, {.relative = 1e-12});
  // The formula of second order starts with steps of order 1, which miss a rising force by h/2 of its change in each:
  // 8e-7 N s (measured).
  check_close(s["momentum"]["linear_kg_m_per_s"][1], impulse, {.relative = 1e-5});
  check_close(s["momentum"]["centre_velocity_m_per_s"][1], impulse / 8, {.relative = 1e-5});
  CHECK(s["momentum"]["largest_deviation_N_s"].get<double>() < 1e-3 * impulse);
  check_close(s["momentum"]["linear_kg_m_per_s"][0], 0, {.absolute = 1e-12});
}

TEST_CASE("a push leaves at least the energy of its momentum and the integrator takes little of it") {
  const auto s = test::run(free_bar(duration)).summary;
  const auto& e = s["energy"];
  const double momentum = s["momentum"]["linear_kg_m_per_s"][1];
  const double of_momentum = momentum * momentum / (2 * 8);
  CHECK(e["kinetic_J"].get<double>() > of_momentum);
  CHECK(e["external_work_J"].get<double>() > e["kinetic_J"].get<double>());
  // The bar rings at some 13 Hz: (omega h)^3/4 a radian is 1e-4 of that part.
  CHECK(std::abs(e["numerical_dissipation_J"].get<double>()) <
        1e-2 * (e["external_work_J"].get<double>() - of_momentum));
  CHECK_FALSE(e.contains("numerical_share"));
}

TEST_CASE("momentum of a held span comes from its supports and goes into the drag") {
  const auto m =
      test::run(taut_span("[damping]\ndrag_N_s_per_m2 = 3\n", {"initial.velocity_mode=1"})).summary["momentum"];
  // Two thirds of 10 kg at 0.01 m/s to begin with, nothing but supports and drag to change it.
  CHECK(std::abs(m["impulse_N_s"][1].get<double>()) > 0.01);
  CHECK(m["largest_deviation_N_s"].get<double>() < 1e-4);
}

TEST_CASE("a probe tells the frequency of its motion") {
  const auto s = test::run(taut_span("")).summary;
  REQUIRE(s["probes"].size() == 2);
  // Clamped: the string's n = 2 raised by 1 + 2/xi + (4 + n^2 pi^2/2)/xi^2, xi = L sqrt(T/EI) = 200; the integrator
  // lowers it by (omega h)^2/3 = 3e-4.
  const double xi = 200;
  const double string = 2 * std::sqrt(4000.0 * (1 + 4e-4)) / 20;
  const double pi = std::numbers::pi;
  const double exact = string * (1 + 2 / xi + (4 + 2 * pi * pi) / (xi * xi));
  const double omega_h = 2 * pi * exact * 5e-4;
  check_close(s["probes"][0]["frequency_Hz"], exact * (1 - omega_h * omega_h / 3), {.relative = 1e-4});
  // The second mode: both antinodes alike, against each other.
  check_close(s["probes"][0]["displacement_m"]["max"][1], -s["probes"][1]["displacement_m"]["min"][1].get<double>(),
              {.relative = 1e-6});
}

TEST_CASE("a transient without probes watches the loaded point and the right end") {
  const auto result = test::run(free_bar(duration));
  const auto& probes = result.summary["probes"];
  REQUIRE(probes.size() == 2);
  check_close(probes[0]["arc_m"], 2, {.relative = 1e-12});
  check_close(probes[1]["arc_m"], 4, {.relative = 1e-12});
  REQUIRE(result.tables.size() == 2);
  CHECK(result.tables[0].file == "histories.csv");
  CHECK(result.tables[0].table.names().size() == 7);
  CHECK(result.tables[1].file == "energies.csv");
  CHECK(result.tables[1].table.rows() == result.tables[0].table.rows());
}

TEST_CASE("a transient stops when asked and keeps its histories") {
  int calls = 0;
  const auto result = test::run(free_bar(duration), {.stop = [&] { return ++calls >= 40; }, .progress = {}});
  CHECK(result.exit_code == ExitCode::interrupted);
  CHECK(result.tables[0].table.rows() == 41);
  CHECK(result.summary["end_time_s"].get<double>() < 0.1);
}

TEST_CASE("a transient needs a step and probes on the span") {
  CHECK_THROWS_WITH_AS(free_bar("duration_s = 1\n"), doctest::Contains("integrator.step_s"), InputError);
  CHECK_THROWS_WITH_AS(free_bar("duration_s = 1\nprobes_m = [4.5]\n[integrator]\nstep_s = 1e-3\n"),
                       doctest::Contains("analysis.probes_m[0]"), InputError);
}

TEST_CASE("a moment that turns a free bar about itself several times does its work in every turn") {
  // A stiff bar in space, I = m L^3/12; rotation vectors are exchanged every half turn.
  for (const std::string method : {"ida", "generalized-alpha"}) {
    CAPTURE(method);
    const auto result = test::run(casefile::read_scene_text(
        fmt::format("[section]\nlaw = \"elastic\"\nEA_N = 1e8\nEI_N_m2 = 1e6\nGJ_N_m2 = 1e6\nmass_kg_per_m = 1\n"
                    "rotary_kg_m = 0.001\npolar_kg_m = 0.001\n[span]\nlength_m = 2\ntension_kN = 0\nelements = 2\n"
                    "grading = \"uniform\"\ndimension = \"spatial\"\nleft = \"free\"\nright = \"free\"\n"
                    "rotary_inertia = true\nmass = \"consistent\"\n"
                    "[[load]]\ntype = \"table\"\nmoment = true\nat_m = 1\nhistory = [[0, 0], [0.5, 10], [1, 10]]\n"
                    "direction = [0, 0, 1]\n[integrator]\nmethod = \"{}\"\nstep_s = 3e-4\n"
                    "[analysis]\ntype = \"transient\"\nduration_s = 2\n",
                    method),
        "test.toml"));
    REQUIRE(result.exit_code == ExitCode::done);
    const auto& energy = result.summary["energy"];
    // The impulse of the moment is 10/4 + 10 (2 - 0.5) N m s: the end of the table stays.
    const double impulse = 2.5 + 15, inertia = 8.0 / 12 + 2 * 0.001;
    check_close(energy["kinetic_J"], impulse * impulse / (2 * inertia), {.relative = 1e-3});
    check_close(energy["external_work_J"], energy["kinetic_J"], {.relative = 1e-3});
  }
}
