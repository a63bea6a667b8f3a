// Error against cost: every number of it by single runs of the base.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/run_case.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using test::check_close;

namespace {

constexpr const char* base = R"([section]
law = "multilinear"
EA_N = 4.7e7
EI_N_m2 = 400
mass_kg_per_m = 1.97
[[section.spring]]
stiffness_N_m2 = 900
yield_per_m = 0.002
[span]
length_m = 8
tension_kN = 30
elements = 40
[integrator]
method = "generalized-alpha"
steps_per_cycle = 50
[analysis]
type = "decay"
mode = 3
antinode_amplitude_mm = 6
cycles = 2
)";
constexpr const char* tradeoff = R"([analysis]
type = "tradeoff"
base = "base.toml"
quantity = "cycles[sum].friction_dissipation_J"
[[analysis.knob]]
key = "span.elements"
values = [10, 20, 40]
[[analysis.knob]]
key = "integrator.method"
values = ["ida", "generalized-alpha"]
)";

double number_of(const results::Value& summary, const std::string& path) {
  const auto verdict = casefile::judge({.criteria = {{.path = path, .above = -1e300}}}, summary, 0).front();
  REQUIRE_MESSAGE(verdict.got.has_value(), path);
  return *verdict.got;
}

struct Files {
  test::ScratchFolder scratch;
  std::filesystem::path base_file = scratch.path() / "base.toml", file = scratch.path() / "tradeoff.toml";
  Files() {
    std::ofstream(base_file) << base;
    std::ofstream(file) << tradeoff;
  }
};

}  // namespace

TEST_CASE("tradeoff: errors and costs are those of single runs of the base") {
  const Files files;
  const auto summary = study::run_case(casefile::read_scene(files.file)).summary;
  const auto run = [&](const char* elements, const char* method) {
    return study::run_case(casefile::read_scene(files.base_file, {std::string("span.elements=") + elements,
                                                                  std::string("integrator.method=") + method}))
        .summary;
  };
  const char* path = "cycles[sum].friction_dissipation_J";
  const auto finest = run("40", "generalized-alpha");
  const double reference = number_of(finest, path);
  CHECK(number_of(summary, "reference.value") == reference);
  CHECK(summary.find("points")->entries().size() == 6);

  double moved = 0;
  for (const results::Value& point : summary.find("points")->entries()) {
    const results::Value& settings = *point.find("settings");
    const auto elements = static_cast<int>(*settings.find("span.elements")->number());
    const std::string method = *settings.find("integrator.method")->words();
    const auto alone = run(std::to_string(elements).c_str(), method.c_str());
    const double error = number_of(alone, path) / reference - 1;
    check_close(*point.find("error")->number(), error, {.absolute = 1e-14});
    check_close(*point.find("cost_ratio")->number(),
                number_of(alone, "cost.section_evaluations") / number_of(finest, "cost.section_evaluations"),
                {.relative = 1e-14});
    const bool one_back = (elements == 20) != (method == "ida") && elements >= 20;
    if (one_back) moved += std::abs(error);
  }
  check_close(number_of(summary, "reference.moved"), moved, {.relative = 1e-12});
}

TEST_CASE("tradeoff: one that was stopped goes on where it was, and computes nothing twice") {
  const Files files;
  const casefile::Scene scene = casefile::read_scene(files.file);
  const std::filesystem::path folder = files.scratch.path() / "out";
  std::filesystem::create_directories(folder);
  const auto summaries = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "settings")) count += entry.is_regular_file();
    return count;
  };
  bool stop = false;
  study::Hooks hooks{.stop = [&] { return stop; },
                     .progress = [&](double part, std::string_view) { stop = part > 0.6; },
                     .folder = folder};
  const study::CaseResult first = study::run_case(scene, hooks);
  CHECK(first.exit_code == ExitCode::interrupted);
  const std::size_t kept = summaries();
  CHECK(kept > 0);
  CHECK(kept < 6);
  CHECK(first.summary.find("points")->entries().size() == kept);

  const auto time = std::filesystem::last_write_time(folder / "settings" / "000.json");
  hooks = {.stop = {}, .progress = {}, .folder = folder, .resume = true};
  const study::CaseResult second = study::run_case(scene, hooks);
  CHECK(second.exit_code == ExitCode::done);
  CHECK(std::filesystem::last_write_time(folder / "settings" / "000.json") == time);
  const auto whole = study::run_case(scene);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string path = "points[" + std::to_string(i) + "].error";
    CHECK(number_of(second.summary, path) == number_of(whole.summary, path));
  }

  // Of another base nothing is taken up.
  std::ofstream(files.base_file) << std::string(base).replace(std::string(base).find("= 900"), 5, "= 800");
  const study::CaseResult other = study::run_case(casefile::read_scene(files.file), hooks);
  CHECK(number_of(other.summary, "reference.value") != number_of(whole.summary, "reference.value"));
}

TEST_CASE("tradeoff: settings that the base refuses together fail in their own row") {
  const Files files;
  std::ofstream(files.file) << R"([analysis]
type = "tradeoff"
base = "base.toml"
quantity = "cycles[sum].friction_dissipation_J"
[[analysis.knob]]
key = "span.tension_kN"
values = [250, 30]
[[analysis.knob]]
key = "section.EA_N"
values = [4e5, 4.7e7]
)";
  const auto result = study::run_case(casefile::read_scene(files.file));
  CHECK(result.exit_code == ExitCode::done);
  const results::Value& together = result.summary.find("points")->entries().back();
  CHECK(*together.find("status")->words() == "failed");
  CHECK(together.find("message")->words()->find("would stretch the span by 0.625") != std::string::npos);
  CHECK_FALSE(*together.find("on_frontier")->flag());
  CHECK(result.summary.find("points")->entries().size() == 4);
}

TEST_CASE("tradeoff: a reference without the quantity ends the study, and says what is missing") {
  const Files files;
  const auto result = study::run_case(casefile::read_scene(files.file, {"analysis.quantity=steady.no_such_number"}));
  CHECK(result.exit_code == ExitCode::not_converged);
  CHECK(result.message.find("steady.no_such_number") != std::string::npos);
  CHECK(result.message.find("span.elements = 40") != std::string::npos);
}
