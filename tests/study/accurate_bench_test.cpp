// What `accuracy` promises of a test bench: knobs that meet the target, and an estimate that covers the error.
#include <doctest/doctest.h>

#include <cmath>

#include "strandyn/casefile/read.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;

namespace {

/// Four metres of Curlew in the third mode; by the test bench, or by the method that is named.
casefile::Scene bench_scene(const std::vector<std::string>& overrides, const std::string& method = "transient") {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"masing\"\n[span]\nlength_m = 4\n"
      "[analysis]\ntype = \"self-damping\"\nmodes = 3\ntensions_rts = 0.2\nantinode_amplitude_mm = 4\nmethod = \"" +
          method + "\"\n",
      "test.toml", overrides);
}

double power(const ordered_json& point) {
  return point["self_damping_W_per_m"];
}

}  // namespace

TEST_CASE("accuracy of a test bench: knobs are chosen, and the estimate covers the difference to the steady state") {
  const ordered_json steady =
      test::run(bench_scene({"span.elements=60", "analysis.periodic.harmonics=9", "analysis.periodic.samples=128"},
                            "periodic"))
          .summary["points"][0];
  const test::Run run = test::run(bench_scene({"accuracy=\"fast\""}));
  const ordered_json& point = run.summary["points"][0];
  const ordered_json& estimate = point["error_estimate"];
  const double error = std::abs(power(point) / power(steady) - 1);
  CHECK(error <= 0.1);
  CHECK(error <= estimate["relative"].get<double>() + 3e-3);  // what is sure of the steady state
  CHECK(estimate["relative"] <= 0.1);
  for (const char* part : {"mesh", "time", "amplitude"}) CHECK(estimate.contains(part));
  CHECK_FALSE(estimate.contains("points"));  // the law has none
  CHECK(point["chosen"]["method"] == "generalized-alpha");
  // Quarters of a cycle are whole steps.
  CHECK(point["bench"]["steps_per_cycle"].get<int>() - point["chosen"]["steps_per_cycle"].get<int>() <= 3);
  CHECK(point["section_evaluations"] > estimate["section_evaluations"].get<double>());
  CHECK(run.summary["error_estimate"]["method"] == "transient");
}

TEST_CASE("accuracy of a test bench: describe says what it begins with, and keeps what the case sets") {
  const auto told = [](const std::vector<std::string>& overrides) {
    return ordered_json::parse(
        results::to_text(study::describe_case(bench_scene(overrides))))["accuracy"]["transient_begins_with"];
  };
  const ordered_json all = told({"accuracy=\"balanced\""});
  for (const char* knob : {"elements", "steps_per_cycle", "amplitude_tolerance"}) CHECK(all[knob] > 0);
  const ordered_json kept = told({"accuracy=\"balanced\"", "span.elements=24", "integrator.steps_per_cycle=100",
                                  "analysis.bench.amplitude_tolerance=1e-3"});
  for (const char* knob : {"elements", "steps_per_cycle", "amplitude_tolerance"}) CHECK_FALSE(kept.contains(knob));
}

TEST_CASE("accuracy of a test bench: a stop is answered while the error is estimated") {
  int asked = 0;
  const test::Run run =
      test::run(bench_scene({"accuracy=\"fast\""}), {.stop = [&] { return ++asked > 20; }, .progress = {}});
  CHECK(run.exit_code == ExitCode::interrupted);
  CHECK(run.summary["points"].empty());
}
