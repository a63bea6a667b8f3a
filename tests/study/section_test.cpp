#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "results/scratch_folder.hpp"
#include "strandyn/conductor/constants.hpp"
#include "study/scenes.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;
using test::section_scene;

namespace {

const results::Table& table(const test::Run& result, const char* file) {
  for (const results::NamedTable& t : result.tables) {
    if (t.file == file) return t.table;
  }
  FAIL("no table ", file);
  return result.tables.front().table;
}

/// Area of the last closed cycle of loop 0 by the trapezoidal rule over the written history.
double area_of_history(const results::Table& history, int steps_per_cycle) {
  const auto& chi = history.column("curvature_per_m");
  const auto& M = history.column("moment_N_m");
  double area = 0;
  for (std::size_t i = chi.size() - static_cast<std::size_t>(steps_per_cycle); i < chi.size(); ++i) {
    area += 0.5 * (M[i] + M[i - 1]) * (chi[i] - chi[i - 1]);
  }
  return area;
}

}  // namespace

TEST_CASE("the area of a loop is the work of the written moments around it") {
  const auto result = test::run(section_scene("curvature_amplitudes_per_m = [0.05]\nsteps_per_cycle = 200\n"));
  const double area = result.summary["loops"][0]["area_J_per_m"];
  CHECK(area > 1);
  // Rounding of a sum of 200 products.
  check_close(area_of_history(table(result, "loop.csv"), 200), area, {.relative = 1e-12});
}

TEST_CASE("a planar path from a file does what the cycles do") {
  const test::ScratchFolder folder;
  const auto cycles = test::run(section_scene("curvature_amplitudes_per_m = [0.05]\nsteps_per_cycle = 200\n"));
  results::Table path({"curvature_2_per_m"});
  for (double chi : table(cycles, "loop.csv").column("curvature_per_m")) path.append(std::array{chi});
  results::write_csv(folder.path() / "path.csv", path);
  const auto result = test::run(section_scene("path = \"" + (folder.path() / "path.csv").string() + "\"\n"));
  const auto& expected = table(cycles, "loop.csv").column("moment_N_m");
  const auto& got = table(result, "path.csv").column("M2_N_m");
  REQUIRE(got.size() == expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) check_close(got[i], expected[i], {.absolute = 1e-9});
}

TEST_CASE("bending about axis 3 from a file gives the moments of bending about axis 2") {
  const test::ScratchFolder folder;
  std::vector<double> results[2];
  for (int axis : {2, 3}) {
    results::Table path({axis == 2 ? "curvature_2_per_m" : "curvature_3_per_m", "torsion_per_m"});
    for (int i = 0; i <= 100; ++i) path.append(std::array{0.05 * std::sin(0.1 * i), 0.0});
    results::write_csv(folder.path() / "path.csv", path);
    const auto result = test::run(section_scene("path = \"" + (folder.path() / "path.csv").string() + "\"\n"));
    results[axis - 2] = table(result, "path.csv").column(axis == 2 ? "M2_N_m" : "M3_N_m");
  }
  // A quarter turn is a grid direction: the same to rounding of moments of some 60 N m.
  for (std::size_t i = 0; i < results[0].size(); ++i) check_close(results[1][i], results[0][i], {.absolute = 1e-9});
}

TEST_CASE("a tension that varies along the path moves the slip limits with it") {
  const test::ScratchFolder folder;
  double lost[2];
  for (int varies : {0, 1}) {
    results::Table path({"tension_N", "curvature_2_per_m"});
    // Curvature is held at a value that sticks at full tension; the tension falls to a quarter.
    for (int i = 0; i <= 50; ++i) path.append(std::array{24420.0, 0.006 * i / 50});
    for (int i = 0; i <= 50; ++i) path.append(std::array{24420.0 * (1 - 0.75 * varies * i / 50), 0.006});
    results::write_csv(folder.path() / "path.csv", path);
    const auto result = test::run(section_scene("path = \"" + (folder.path() / "path.csv").string() + "\"\n"));
    lost[varies] = result.summary["path"]["dissipated_J_per_m"];
  }
  CHECK(lost[0] == 0);
  CHECK(lost[1] > 0);
}

TEST_CASE("a path meets the tension that it asks for, and what its work is beyond the books has a name") {
  const test::ScratchFolder folder;
  results::Table path({"curvature_2_per_m", "tension_N"});
  constexpr int steps = 200;
  for (int i = 0; i <= 2 * steps; ++i) {
    const double phase = 2 * std::numbers::pi * i / steps;
    path.append(std::array{0.05 * std::sin(phase), 28e3 + 3e3 * std::sin(phase + 0.7)});
  }
  results::write_csv(folder.path() / "path.csv", path);
  const std::string file = "path = \"" + (folder.path() / "path.csv").string() + "\"\n";
  for (const bool resultants : {false, true}) {
    CAPTURE(resultants);
    const auto result = test::run(
        section_scene(file, {resultants ? "section.axial_resultants=true" : "section.axial_resultants=false"}));
    const results::Table& rows = table(result, "path.csv");
    const auto& N = rows.column("N_N");
    double work = 0;
    for (std::size_t i = 0; i < N.size(); ++i) {
      check_close(N[i], path.column("tension_N")[i], {.relative = 1e-9});
      if (i == 0) continue;
      for (const auto& [strain, stress] : {std::pair{"axial_strain", "N_N"}, {"curvature_2_per_m", "M2_N_m"}}) {
        const auto& s = rows.column(stress);
        work += (s[i] + s[i - 1]) / 2 * (rows.column(strain)[i] - rows.column(strain)[i - 1]);
      }
    }
    const auto& books = result.summary["path"];
    check_close(books["work_J_per_m"], work, {.relative = 1e-9});
    const double stored = rows.column("stored_J_per_m").back() - rows.column("stored_J_per_m").front();
    const double dissipated = books["dissipated_J_per_m"], unaccounted = books["unaccounted_work_J_per_m"];
    const double steps_error = books["quadrature_error_J_per_m"];
    check_close(work, stored + dissipated - steps_error + unaccounted, {.relative = 1e-9});
    if (resultants) {
      CHECK(std::abs(unaccounted) > 1e-4 * dissipated);
    } else {
      CHECK(std::abs(unaccounted) <= 1e-9 * dissipated);
    }
  }
}

TEST_CASE("a path with an unknown column is refused with the columns there are") {
  const test::ScratchFolder folder;
  std::ofstream(folder.path() / "path.csv") << "curvature\n0.1\n";
  CHECK_THROWS_WITH_AS(test::run(section_scene("path = \"" + (folder.path() / "path.csv").string() + "\"\n")),
                       doctest::Contains("curvature_2_per_m"), InputError);
}

TEST_CASE("free to twist the section twists and the limits of the layers change") {
  const std::string analysis = "curvature_amplitudes_per_m = [0.05]\nsteps_per_cycle = 200\n";
  const double held = test::run(section_scene(analysis)).summary["loops"][0]["area_J_per_m"];
  const double loose = test::run(section_scene(analysis + "twist = \"free\"\n")).summary["loops"][0]["area_J_per_m"];
  CHECK(std::abs(loose - held) > 1e-3 * held);
}

TEST_CASE("loops by friction and with and without residual forces are those of the single cases") {
  const std::string analysis = "curvature_amplitudes_per_m = [0.04]\nsteps_per_cycle = 200\n";
  const auto both = test::run(section_scene(analysis + "frictions = [0.5]\ncompare_residual_forces = true\n")).summary;
  REQUIRE(both["loops"].size() == 2);
  const std::vector<std::string> half = {"conductor.friction=0.5"};
  const double with = test::run(section_scene(analysis, half)).summary["loops"][0]["area_J_per_m"];
  const double without =
      test::run(section_scene(analysis, {"conductor.friction=0.5", "conductor.residual_forces=false"}))
          .summary["loops"][0]["area_J_per_m"];
  check_close(both["loops"][0]["area_J_per_m"], with, {.relative = 1e-14});
  check_close(both["loops"][1]["area_J_per_m"], without, {.relative = 1e-14});
  check_close(both["without_residual_forces"][0]["area_lower"], 1 - without / with, {.relative = 1e-12});
}

TEST_CASE("wires stick at small curvature and their bending force is that of a plane section") {
  const auto result = test::run(section_scene("curvature_amplitudes_per_m = [0.05]\nwires_at_per_m = [0.001]\n"));
  const auto& wires = table(result, "wires.csv");
  const casefile::Scene scene = section_scene("curvature_amplitudes_per_m = [0.05]\n");
  const conductor::Strand& strand = scene.conductor->strand;
  const double eps = 0.15 * 162.8e3 / conductor::section_constants(strand).EA;
  for (std::size_t i = 0; i < wires.rows(); ++i) {
    const auto& layer = strand.layers[static_cast<std::size_t>(wires.column("layer")[i])];
    const double c2 = std::pow(std::cos(layer.lay_angle), 2);
    const double plane =
        layer.EA_wire() * c2 * (eps + layer.helix_radius * std::sin(wires.column("theta_rad")[i]) * 1e-3);
    CHECK(wires.column("slips")[i] == 0);
    // Up to a midpoint the midpoint rule gives sin(theta) (1 - dtheta^2/12): 2.54e-3 of the bending part at 36 points.
    check_close(wires.column("force_N")[i], plane,
                {.absolute = 2.6e-3 * layer.EA_wire() * c2 * layer.helix_radius * 1e-3});
  }
}
