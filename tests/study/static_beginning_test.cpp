// Where slip begins on a static path, whatever steps the path takes.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "strandyn/casefile/read.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;

namespace {

test::Run pushed(int steps, const std::string& more = "") {
  return test::run(
      casefile::read_scene_text(fmt::format("[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n"
                                            "[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 40\n"
                                            "[[load]]\ntype = \"static-force\"\nat_m = 5\nforce_N = 400\n{}"
                                            "[analysis]\ntype = \"static\"\nsteps = {}\n",
                                            more, steps),
                                "test.toml"));
}

}  // namespace

TEST_CASE("static path: first slip and initial stiffness do not depend on the steps of the path") {
  const auto few = pushed(5).summary, many = pushed(100).summary;
  const double slip = many["first_slip_load_N"];
  CHECK(slip > 0);
  check_close(few["first_slip_load_N"], slip, {.relative = 2e-3});
  check_close(few["initial_stiffness_N_per_m"], many["initial_stiffness_N_per_m"], {.relative = 1e-3});
  // The steps agree: one below slips nowhere, the next one does.
  bool before = true;
  for (const auto& step : many["steps"]) {
    const bool slips = step["sections_slipping"].get<int>() > 0;
    if (before && slips) {
      CHECK(step["load_N"].get<double>() >= slip * (1 - 1e-3));
      CHECK(step["load_N"].get<double>() - 4 <= slip * (1 + 1e-3));
      before = false;
    }
  }
  // Not yet slipping, the strand is a beam of EI_max: the law "stick".
  const auto stick = pushed(5, "[section]\nlaw = \"stick\"\n").summary;
  check_close(few["initial_stiffness_N_per_m"], stick["initial_stiffness_N_per_m"], {.relative = 1e-6});
}

TEST_CASE("static path: contacts that give slip from the first load on") {
  const auto s = pushed(2, "[section]\nlaw = \"compliant\"\n").summary;
  CHECK(s["first_slip_load_N"].get<double>() == 0);
}

TEST_CASE("static path: a load that no strand bears is said") {
  const auto run = pushed(5);
  CHECK(run.warnings.empty());
  const auto broken = test::run(casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\n[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 20\n"
      "[[load]]\ntype = \"static-force\"\nat_m = 5\nforce_N = 1e6\n[analysis]\ntype = \"static\"\nsteps = 20\n",
      "test.toml"));
  REQUIRE(broken.warnings.size() == 1);
  CHECK(broken.warnings[0].find("times the rated strength") != std::string::npos);
}
