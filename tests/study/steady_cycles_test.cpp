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
