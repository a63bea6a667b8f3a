// What `accuracy` promises of a self-damping study: tables and periodic points that meet the target, and estimates that
// cover the error.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "results/scratch_folder.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "study/self_damping_scene.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using test::damping_scene;

namespace {

const std::string grid =
    "frequencies_Hz = [10, 40]\namplitude_over_diameter = [0.1, 0.3, 0.6]\ntensions_rts = [0.15, 0.3]\n";
const std::vector<std::string> converged_table = {"analysis.quadrature.steps=256",
                                                  "analysis.quadrature.knots_per_decade=48",
                                                  "analysis.quadrature.tolerance=2e-4", "section.points=144"};

/// Six metres of Curlew in the fourth mode.
casefile::Scene periodic_scene(const std::string& amplitudes, const std::vector<std::string>& overrides) {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"return-map\"\n"
      "[span]\nlength_m = 6\n[analysis]\ntype = \"self-damping\"\nmethod = \"periodic\"\nmodes = 4\n"
      "tensions_rts = 0.2\nantinode_amplitude_mm = " +
          amplitudes + "\n",
      "test.toml", overrides);
}

/// The largest error of the points, over the larger of their loss and 1e-4 of the energy.
double error_of(const ordered_json& points, const ordered_json& converged, double mass) {
  double largest = 0;
  REQUIRE(points.size() == converged.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double exact = converged[i]["self_damping_W_per_m"], f = converged[i]["frequency_Hz"];
    const double velocity = 2 * 3.14159265358979 * f * converged[i]["antinode_amplitude_m"].get<double>();
    const double size = std::max(exact, f * 1e-4 * mass * velocity * velocity / 4);
    largest = std::max(largest, std::abs(points[i]["self_damping_W_per_m"].get<double>() - exact) / size);
  }
  return largest;
}

bool warns(const test::Run& run) {
  return std::ranges::any_of(run.warnings, [](const std::string& warning) {
    return warning.find("points may be off by more than the") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("accuracy of a study by quadrature: presets are within their target, and their estimates cover the error") {
  const std::string points = "frequencies_Hz = [20, 40]\namplitude_over_diameter = [0.3, 0.6]\ntensions_rts = 0.2\n";
  for (const char* law : {"return-map", "masing", "compliant"}) {
    CAPTURE(law);
    const casefile::Scene fine = damping_scene(law, points, converged_table);
    const ordered_json converged = test::run(fine).summary["points"];
    double evaluations = 0;
    for (const auto& [word, target] : {std::pair{"fast", 0.1}, {"balanced", 0.02}, {"reference", 0.002}}) {
      CAPTURE(word);
      const test::Run run = test::run(damping_scene(law, points, {std::string("accuracy=\"") + word + '"'}));
      const ordered_json& estimate = run.summary["error_estimate"];
      const double error = error_of(run.summary["points"], converged, *casefile::mass_per_length(fine));
      CHECK(error <= target);
      CHECK(error <= estimate["relative"].get<double>() + 1e-4);  // what is sure of the converged one
      CHECK(estimate["target"] == target);
      CHECK(warns(run) == (estimate["relative"] > target));
      CHECK((estimate["points_above_target"] > 0) == (estimate["relative"] > target));
      const double took = run.summary["cost"]["section_evaluations"];
      CHECK(took > evaluations);
      CHECK(took > estimate["section_evaluations"].get<double>());
      evaluations = took;
    }
  }
}

TEST_CASE("accuracy of a study: a knob that the case sets is kept, covered by the estimate, and said") {
  const casefile::Scene fine = damping_scene("return-map", grid, converged_table);
  const ordered_json converged = test::run(fine).summary["points"];
  const test::Run run = test::run(damping_scene(
      "return-map", grid, {"accuracy=\"reference\"", "analysis.quadrature.steps=8", "section.points=12"}));
  const ordered_json& row = run.summary["points"][0];
  CHECK_FALSE(row["chosen"].contains("steps"));
  CHECK_FALSE(row["chosen"].contains("points"));
  CHECK(row["chosen"].contains("knots_per_decade"));
  const ordered_json& estimate = run.summary["error_estimate"];
  CHECK(estimate["steps"] > 0.002);
  CHECK(estimate["points"] > 0.002);
  CHECK(estimate["relative"].get<double>() >=
        error_of(run.summary["points"], converged, *casefile::mass_per_length(fine)));
  CHECK(estimate["points_above_target"] == 12);
  CHECK(warns(run));
}

TEST_CASE("accuracy of a study: the points are those of the table that the summary says was chosen") {
  const std::string one = "frequencies_Hz = 20\namplitude_over_diameter = [0.1, 0.4]\ntensions_rts = 0.2\n";
  const ordered_json chosen = test::run(damping_scene("return-map", one, {"accuracy=0.01"})).summary["points"];
  const ordered_json& knobs = chosen[0]["chosen"];
  const ordered_json by_hand =
      test::run(damping_scene("return-map", one,
                              {"analysis.quadrature.steps=" + knobs["steps"].dump(),
                               "analysis.quadrature.knots_per_decade=" + knobs["knots_per_decade"].dump(),
                               "analysis.quadrature.tolerance=" + knobs["tolerance"].dump(),
                               "section.points=" + knobs["points"].dump()}))
          .summary["points"];
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(chosen[i]["self_damping_W_per_m"] == by_hand[i]["self_damping_W_per_m"]);
    CHECK_FALSE(by_hand[i].contains("error_estimate"));
  }
}

TEST_CASE("accuracy of a study: where nothing slips there is no error, and a law without points has none of them") {
  const ordered_json stick = test::run(damping_scene("stick", grid, {"accuracy=\"reference\""})).summary;
  CHECK(stick["error_estimate"]["relative"] == 0.0);
  const ordered_json masing = test::run(damping_scene("masing", grid, {"accuracy=\"fast\""})).summary;
  CHECK_FALSE(masing["error_estimate"].contains("points"));
  CHECK_FALSE(masing["points"][0]["chosen"].contains("points"));
}

TEST_CASE("accuracy of a study: one that goes on has the numbers and estimates of one that was not stopped") {
  const casefile::Scene scene = damping_scene("return-map", grid, {"accuracy=\"fast\""});
  const test::ScratchFolder whole, parted;
  const ordered_json expected = test::run(scene, {.stop = {}, .progress = {}, .folder = whole.path()}).summary;
  bool stop = false;
  const auto begun = [&](double, std::string_view what) { stop = stop || what.starts_with("point 3 of"); };
  const study::Hooks first = {.stop = [&] { return stop; }, .progress = begun, .folder = parted.path()};
  const test::Run stopped = test::run(scene, first);
  CHECK(stopped.exit_code == ExitCode::interrupted);
  const ordered_json resumed =
      test::run(scene, {.stop = {}, .progress = {}, .folder = parted.path(), .resume = true}).summary;
  CHECK(resumed["points"] == expected["points"]);
  CHECK(resumed["error_estimate"] == expected["error_estimate"]);
  CHECK(resumed["cost"]["section_evaluations"] == expected["cost"]["section_evaluations"]);
}

TEST_CASE("accuracy of a study by periodic: presets are within their target, and their estimates cover the error") {
  // By 64 elements, 9 harmonics, 96 samples and 36 points; half a minute, so it stands here.
  const double converged = 40.130;  // [W/m]
  for (const auto& [word, target] : {std::pair{"fast", 0.1}, {"balanced", 0.02}}) {
    CAPTURE(word);
    const test::Run run = test::run(periodic_scene("6", {std::string("accuracy=\"") + word + '"'}));
    const ordered_json& estimate = run.summary["error_estimate"];
    const double error = std::abs(run.summary["points"][0]["self_damping_W_per_m"].get<double>() / converged - 1);
    CHECK(error <= target);
    CHECK(error <= estimate["relative"].get<double>() + 1e-3);  // what is sure of the converged one
    CHECK(estimate["relative"] <= target);
    CHECK(estimate["method"] == "periodic");
    for (const char* part : {"mesh", "harmonics", "samples", "points"}) CHECK(estimate.contains(part));
    for (const ordered_json& row : run.summary["points"]) {
      CHECK(row["chosen"]["elements"] == row["elements"]);
      CHECK(row["chosen"]["harmonics"] == row["harmonics"]);
      CHECK(row["section_evaluations"] > row["error_estimate"]["section_evaluations"].get<double>());
    }
  }
}

TEST_CASE("accuracy of a study by periodic: what the case sets is kept, and what it costs is said") {
  const test::Run run =
      test::run(periodic_scene("3", {"accuracy=0.02", "span.elements=16", "analysis.periodic.harmonics=1"}));
  const ordered_json& row = run.summary["points"][0];
  CHECK(row["elements"] == 16);
  CHECK(row["harmonics"] == 1);
  CHECK_FALSE(row["chosen"].contains("elements"));
  CHECK_FALSE(row["chosen"].contains("harmonics"));
  CHECK(row["chosen"].contains("samples"));
  CHECK(row["error_estimate"]["mesh"] > 0.02);
  CHECK(warns(run));
}

TEST_CASE("accuracy of a study by periodic: a stop is answered within a point") {
  int asked = 0;
  const test::Run run =
      test::run(periodic_scene("3", {"accuracy=\"balanced\""}), {.stop = [&] { return ++asked > 20; }, .progress = {}});
  CHECK(run.exit_code == ExitCode::interrupted);
  CHECK(run.summary["points"].empty());
}

TEST_CASE("accuracy of a study: describe says what it begins with, and that the choice is made in the run") {
  const auto told = [](const casefile::Scene& scene) {
    return ordered_json::parse(results::to_text(study::describe_case(scene)))["accuracy"];
  };
  const ordered_json table = told(damping_scene("return-map", grid, {"accuracy=\"balanced\""}));
  CHECK(table["target"] == 0.02);
  CHECK(table["chosen"].get<std::string>().starts_with("in the run"));
  CHECK(table["quadrature_begins_with"]["steps"] >= 8);
  const ordered_json periodic = told(periodic_scene("3", {"accuracy=\"balanced\""}));
  CHECK(periodic["periodic_begins_with"]["elements"] >= 8);
  CHECK(told(damping_scene("return-map", grid)).is_null());
}
