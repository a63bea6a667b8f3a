// What `accuracy` promises of a sweep: knobs that meet the target at its resonance, and an estimate that covers the
// error.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "strandyn/casefile/read.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;

namespace {

/// Three metres of Curlew in the first mode; more of [analysis] follows.
casefile::Scene sweep_scene(const std::string& force, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"masing\"\n"
      "[span]\nlength_m = 3\ntension_rts = 0.2\n"
      "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.5\nfrequency = \"mode 1\"\namplitude_N = " +
          force + "\n[analysis]\ntype = \"sweep\"\nbackbone_points = 1\n",
      "test.toml", overrides);
}

bool warns(const test::Run& run, const char* words) {
  return std::ranges::any_of(run.warnings,
                             [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

}  // namespace

TEST_CASE("accuracy of a sweep: knobs are chosen, and the estimate covers the difference to a finer run") {
  const ordered_json fine =
      test::run(sweep_scene("8", {"span.elements=40", "analysis.periodic.harmonics=7", "analysis.periodic.samples=96"}))
          .summary;
  const test::Run run = test::run(sweep_scene("8", {"accuracy=\"fast\""}));
  const ordered_json& estimate = run.summary["error_estimate"];
  const auto power = [](const ordered_json& summary) {
    return summary["resonance"]["dissipated_power_W"].get<double>();
  };
  const double error = std::abs(power(run.summary) / power(fine) - 1);
  CHECK(error <= 0.1);
  CHECK(error <= estimate["relative"].get<double>() + 1e-3);  // what is sure of the finer one
  CHECK(estimate["relative"] <= 0.1);
  CHECK(estimate["target"] == 0.1);
  double sum = 0;
  for (const char* part : {"mesh", "harmonics", "samples", "curve"}) sum += estimate[part].get<double>();
  CHECK(std::abs(estimate["relative"].get<double>() - sum) < 1e-12);
  for (const char* knob : {"elements", "harmonics", "samples"}) CHECK(run.summary["chosen"][knob] > 0);
  CHECK_FALSE(run.summary["chosen"].contains("points"));  // the law has none
  CHECK(run.warnings.empty());
}

TEST_CASE("accuracy of a sweep: a knob that the case sets is kept, and what it costs is said") {
  const test::Run run =
      test::run(sweep_scene("8", {"accuracy=0.002", "span.elements=12", "analysis.periodic.harmonics=3"}));
  CHECK_FALSE(run.summary["chosen"].contains("elements"));
  CHECK_FALSE(run.summary["chosen"].contains("harmonics"));
  CHECK(run.summary["chosen"].contains("samples"));
  CHECK(run.summary["error_estimate"]["mesh"] > 0.002);
  CHECK(warns(run, "at resonance may be off by"));
}

TEST_CASE("accuracy of a sweep: where nothing holds an amplitude no error is known, and the run says so") {
  const test::Run run = test::run(
      sweep_scene("8", {"accuracy=\"fast\"", "section.law=\"stick\"", "analysis.from_Hz=20", "analysis.to_Hz=21"}));
  CHECK_FALSE(run.summary["error_estimate"].contains("relative"));
  CHECK(warns(run, "is off by is not known"));
}

TEST_CASE("accuracy of a sweep: describe says what it begins with, a stop is answered while the error is estimated") {
  const ordered_json told =
      ordered_json::parse(results::to_text(study::describe_case(sweep_scene("8", {"accuracy=\"balanced\""}))));
  CHECK(told["chosen"]["elements"] >= 8);
  CHECK(told["chosen"]["swing_step"] == 0.1);
  int asked = 0;
  const test::Run run =
      test::run(sweep_scene("8", {"accuracy=\"balanced\""}), {.stop = [&] { return ++asked > 10; }, .progress = {}});
  CHECK(run.exit_code == ExitCode::interrupted);
}
