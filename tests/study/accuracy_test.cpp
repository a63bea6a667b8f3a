// What `accuracy` promises: mesh, steps and points that meet the target, and an estimate that covers the error.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "strandyn/study/run_case.hpp"
#include "study/scenes.hpp"

using namespace strandyn;
using casefile::number_at;
using casefile::Scene;
using test::span_scene;

namespace {

constexpr const char* decay = "[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 4\ncycles = 3\n";

/// `span_scene` names elements, as a user may; here the program is to choose them.
Scene with_accuracy(const std::string& accuracy, std::vector<std::string> overrides = {}) {
  overrides.push_back("accuracy=" + accuracy);
  Scene scene = span_scene(decay, overrides);
  scene.span->elements.reset();
  return scene;
}

double friction(const study::CaseResult& result) {
  return number_at("cycles[sum].friction_dissipation_J", result.summary).value();
}

bool warns_of_error(const study::CaseResult& result) {
  return std::ranges::any_of(result.warnings, [](const std::string& warning) {
    return warning.find("the dissipation may be off by") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("accuracy: each preset is within its target of the converged friction, and its estimate covers the error") {
  Scene fine = span_scene(decay, {"integrator.steps_per_cycle=1200", "span.elements=200", "section.points=72"});
  const double converged = friction(study::run_case(fine));  // by IDA, where the presets take generalized-alpha
  double evaluations = 0;
  for (const auto& [word, target] :
       {std::pair{"fast", 0.1}, {"balanced", 0.02}, {"reference", 0.002}, {"0.01", 0.01}}) {
    CAPTURE(word);
    const study::CaseResult result = study::run_case(with_accuracy(word));
    const double error = std::abs(friction(result) / converged - 1);
    const double estimate = number_at("error_estimate.relative", result.summary).value();
    CHECK(result.exit_code == ExitCode::done);
    CHECK(number_at("error_estimate.target", result.summary).value() == target);
    CHECK(error <= target);
    CHECK(error <= estimate + 2e-4);  // what is sure of the converged one
    CHECK(estimate <= target);
    CHECK_FALSE(warns_of_error(result));
    if (target == 0.01) continue;
    CHECK(static_cast<double>(result.cost.section_evaluations) > evaluations);
    evaluations = static_cast<double>(result.cost.section_evaluations);
  }
}

TEST_CASE("accuracy: the run is that of the settings which the summary says were chosen") {
  const study::CaseResult chosen = study::run_case(with_accuracy("balanced"));
  const auto of = [&](const char* key) { return number_at(std::string("chosen.") + key, chosen.summary).value(); };
  Scene scene = span_scene(decay, {"integrator.method=\"generalized-alpha\""});
  scene.span->elements = static_cast<int>(of("span.elements"));
  scene.integrator.steps_per_cycle = static_cast<int>(of("integrator.steps_per_cycle"));
  scene.section.points = static_cast<int>(of("section.points"));
  const study::CaseResult by_hand = study::run_case(scene);
  CHECK(friction(by_hand) == friction(chosen));
  // The work of the estimate is in the cost, and beside it.
  const double estimate = number_at("error_estimate.section_evaluations", chosen.summary).value();
  CHECK(estimate > 0);
  CHECK(static_cast<double>(chosen.cost.section_evaluations) ==
        estimate + static_cast<double>(by_hand.cost.section_evaluations));
}

TEST_CASE("accuracy: what the user sets is kept, and said where it costs the target") {
  const Scene scene = span_scene(decay, {"accuracy=0.005", "span.elements=12", "integrator.method=\"ida\""});
  const study::CaseResult result = study::run_case(scene);
  CHECK_FALSE(number_at("chosen.span.elements", result.summary));
  CHECK(result.summary.find("chosen")->find("integrator")->find("method") == nullptr);
  CHECK(number_at("chosen.integrator.steps_per_cycle", result.summary));
  CHECK(number_at("error_estimate.mesh", result.summary).value() > 0.005);
  CHECK(warns_of_error(result));
}

TEST_CASE("accuracy: an error that cannot be estimated is no number, and the run says so") {
  // Half of ten elements have no eighth mode.
  const Scene scene = span_scene(decay, {"accuracy=\"fast\"", "span.elements=10", "analysis.mode=8"});
  const study::CaseResult result = study::run_case(scene);
  CHECK(result.summary.find("cycles"));
  CHECK_FALSE(number_at("error_estimate.relative", result.summary));
  CHECK_FALSE(number_at("error_estimate.mesh", result.summary));
  CHECK(number_at("error_estimate.target", result.summary).value() == 0.1);
  CHECK(std::ranges::any_of(result.warnings, [](const std::string& warning) {
    return warning.find("is off by is not known") != std::string::npos;
  }));
}

TEST_CASE("accuracy: steps are refined four times at most, and what is not reached is said") {
  // 650 are begun with.
  const study::CaseResult result = study::run_case(with_accuracy("1e-4", {"span.length_m=3", "analysis.mode=1"}));
  const double steps = number_at("chosen.integrator.steps_per_cycle", result.summary).value();
  CHECK(steps >= 650);
  CHECK(steps <= 4 * 650);
  CHECK(warns_of_error(result) == (number_at("error_estimate.relative", result.summary).value() > 1e-4));
}

TEST_CASE("accuracy: where nothing is lost there is no error, and nothing is refined") {
  const study::CaseResult result = study::run_case(with_accuracy("reference", {"section.law=\"stick\""}));
  CHECK(result.exit_code == ExitCode::done);
  CHECK(number_at("error_estimate.relative", result.summary).value() == 0);
  CHECK_FALSE(number_at("error_estimate.points", result.summary));
  CHECK_FALSE(number_at("chosen.section.points", result.summary));
}

TEST_CASE("accuracy: a stop is answered while the error is estimated") {
  int asked = 0;
  const study::Hooks hooks{.stop = [&] { return ++asked > 3; }, .progress = {}};
  const study::CaseResult result = study::run_case(with_accuracy("reference"), hooks);
  CHECK(result.exit_code == ExitCode::interrupted);
  CHECK(result.message.find("error was estimated") != std::string::npos);
}
