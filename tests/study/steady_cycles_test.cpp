#include <doctest/doctest.h>

#include <algorithm>

#include "strandyn/casefile/read.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;

TEST_CASE("a mean over cycles that still grow is not called steady" * doctest::test_suite("slow")) {
  const auto lab_span = [](const std::string& cycles) {
    return casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml", {"analysis.cycles=" + cycles});
  };
  const auto growing = test::run(lab_span("30"));
  CHECK_FALSE(growing.summary["steady"]["is_steady"].get<bool>());
  CHECK(growing.summary["steady"]["work_in_over_lost"].get<double>() > 5);
  CHECK(growing.exit_code == ExitCode::done);
  CHECK(growing.summary["warnings"][0].get<std::string>().find("not steady: ") == 0);
  CHECK(std::ranges::count(growing.highlights, "self-damping (not steady)", &results::Highlight::name) == 1);

  const auto steady = test::run(lab_span("300"));
  CHECK(steady.summary["steady"]["is_steady"].get<bool>());
  check_close(steady.summary["steady"]["work_in_over_lost"], 1, {.relative = 5e-3});
  CHECK(steady.summary["warnings"].empty());
  CHECK(std::ranges::count(steady.highlights, "self-damping", &results::Highlight::name) == 1);
}

TEST_CASE("contacts that give do not drift: cycles 200 and 400 of a span at constant drive lose the same" *
          doctest::test_suite("slow")) {
  const auto run = test::run(casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"compliant\"\npoints = 12\n"
      "[span]\nlength_m = 6\ntension_rts = 0.2\nelements = 16\n"
      "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.6\namplitude_N = 60\nfrequency = \"mode 3\"\n"
      "[integrator]\nmethod = \"generalized-alpha\"\nsteps_per_cycle = 60\n"
      "[analysis]\ntype = \"forced\"\ncycles = 400\n",
      "test.toml"));
  const auto& cycles = run.summary["cycles"];
  REQUIRE(cycles.size() == 400);
  const double late = cycles[399]["friction_dissipation_J"];
  CHECK(late > 0.1);  // the clamps and the free span slip
  check_close(cycles[199]["friction_dissipation_J"], late, {.relative = 5e-3});
  CHECK(run.summary["steady"]["is_steady"].get<bool>());
}
