#include "strandyn/report/progress.hpp"

#include <doctest/doctest.h>

#include <sstream>

using strandyn::report::Progress;
using strandyn::report::ProgressOptions;

namespace {

/// A progress line that writes into a text, on a clock set by hand.
struct Bench {
  std::ostringstream out;
  double now = 1000;

  ProgressOptions options(bool terminal) {
    return {.out = &out, .terminal = terminal, .clock_s = [this] { return now; }};
  }
  std::string taken() {
    std::string text = out.str();
    out.str({});
    return text;
  }
};

}  // namespace

TEST_CASE("progress: on a terminal a bar is rewritten in place, with the time left") {
  Bench bench;
  Progress progress(bench.options(true));
  progress.update(0, "t = 0 s");
  CHECK(bench.taken() == "\r[>                       ]   0 %  t = 0 s");
  bench.now += 10;
  progress.update(0.25, "t = 1 s, cycle 50 of 200");
  CHECK(bench.taken() == "\r[======>                 ]  25 %  t = 1 s, cycle 50 of 200, 30 s left");
  bench.now += 0.05;  // too soon to be seen
  progress.update(0.26, "t = 1.04 s");
  CHECK(bench.taken().empty());
  bench.now += 9.95;
  progress.update(0.5, "t = 2 s");
  // Blanks wipe out the rest of the longer line before.
  CHECK(bench.taken() == "\r[============>           ]  50 %  t = 2 s, 20 s left                 ");
  bench.now += 20;
  progress.update(1, "t = 4 s");
  bench.taken();
  progress.finish();
  CHECK(bench.taken() == "\r[========================] 100 %  t = 4 s, took 40 s\n");
}

TEST_CASE("progress: elsewhere there is a plain line per tenth, not more often than every few seconds") {
  Bench bench;
  Progress progress(bench.options(false));
  for (int i = 0; i <= 100; ++i) {
    progress.update(0.01 * i, "running");
    bench.now += 0.1;
  }
  // Ten seconds in all: lines are due at the first update three seconds after the last that is in a further tenth.
  CHECK(bench.taken() == " 30 %  running, 7 s left\n 60 %  running, 4 s left\n 90 %  running, 1 s left\n");
  progress.finish();
  CHECK(bench.taken() == "100 %  running, took 10 s\n");
}

TEST_CASE("progress: a slow run shows life every minute") {
  Bench bench;
  Progress progress(bench.options(false));
  progress.update(0, "running");
  for (int i = 1; i <= 12; ++i) {
    bench.now += 10;
    progress.update(0.001 * i, "running");
  }
  CHECK(bench.taken() == "  0 %  running, 2 h 46 min left\n  1 %  running, 2 h 45 min left\n");
}

TEST_CASE("progress: a resumed run counts its own pace") {
  Bench bench;
  Progress progress(bench.options(true));
  progress.update(0.5, "resumed");
  bench.now += 10;
  progress.update(0.6, "resumed");
  // A tenth took ten seconds, four tenths are to come.
  CHECK(bench.taken().ends_with(" 60 %  resumed, 40 s left"));
}

TEST_CASE("progress: a line never exceeds the terminal and is never cut within a character") {
  Bench bench;
  auto options = bench.options(true);
  options.columns = 40;  // one is left free: some terminals wrap a full line
  Progress progress(options);
  progress.update(0, "ψψψψψψψψψψψψψψψψψψψψ");
  CHECK(bench.taken() == "\r[>                       ]   0 %  ψψψψψ");
}

TEST_CASE("progress: a run that breaks off leaves the cursor on a fresh line") {
  Bench bench;
  {
    Progress progress(bench.options(true));
    progress.update(0.1, "running");
    bench.taken();
  }
  CHECK(bench.taken() == "\n");
}

TEST_CASE("progress: quiet, without a stream, or never begun, it writes nothing") {
  Bench bench;
  auto options = bench.options(true);
  options.quiet = true;
  {
    Progress quiet(options);
    quiet.update(0.5, "running");
    quiet.finish();
    Progress unused(bench.options(true));
    unused.finish();
    Progress without_stream({});
    without_stream.update(0.5, "running");
    without_stream.finish();
  }
  CHECK(bench.taken().empty());
}
