// Histories that lie in a file beside the case: the record of a shaker is long.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>

#include "results/scratch_folder.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/json.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using test::message_of;
using test::ScratchFolder;

namespace {

std::string span_with(const std::string& tables) {
  return "[conductor]\ncatalogue = \"curlew\"\n[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 30\n" + tables +
         "[integrator]\nstep_s = 1e-3\n[analysis]\ntype = \"transient\"\nduration_s = 0.1\n";
}

const std::string motion = "[[motion]]\ntype = \"table\"\nat = \"left\"\n";
const std::string load = "[[load]]\ntype = \"table\"\nat_m = 5\n";

casefile::Scene read(const ScratchFolder& folder, const std::string& tables) {
  return casefile::read_scene_text(span_with(tables), (folder / "case.toml").string());
}

std::string refusal(const ScratchFolder& folder, const std::string& tables) {
  return message_of<InputError>([&] { read(folder, tables); });
}

void write(const ScratchFolder& folder, const std::string& text) {
  std::ofstream(folder / "record.csv") << text;
}

}  // namespace

TEST_CASE("a history from a file is the same case as one that is written out") {
  const ScratchFolder folder;
  const auto same = [&](const std::string& head, const std::string& columns, const std::string& rows,
                        const std::string& written) {
    write(folder, columns + "\n" + rows);
    const auto echo_of = [](const casefile::Scene& scene) { return results::to_text(casefile::case_as_run(scene)); };
    CHECK(echo_of(read(folder, head + "history_file = \"record.csv\"\n")) ==
          echo_of(read(folder, head + "history = " + written + "\n")));
  };
  same(motion, "time_s,displacement_mm", "0,0\n0.1, 3.52\n0.3,-1\n", "[[0, 0], [0.1, 3.52], [0.3, -1]]");
  same(motion + "rotation = true\n", "time_s,rotation_deg", "0,0\n0.1,2\n", "[[0, 0], [0.1, 2]]");
  same(load, "force_N,time_s", "0,0\n7,0.1\n", "[[0, 0], [0.1, 7]]");
  same(load + "moment = true\n", "time_s,moment_N_m", "0,0\n0.1,7\n", "[[0, 0], [0.1, 7]]");
}

TEST_CASE("a history from a file is read in millimetres and smooth where it is sampled") {
  const ScratchFolder folder;
  std::string rows = "time_s,displacement_mm\n";
  for (int i = 0; i < 20; ++i) rows += fmt::format("{},{}\n", 0.01 * i, i % 3);
  write(folder, rows);
  const casefile::Scene scene = read(folder, motion + "history_file = \"record.csv\"\n");
  REQUIRE(scene.motions[0].history.size() == 20);
  test::check_close(scene.motions[0].history[2][1], 2e-3, {.relative = 1e-15});
  CHECK(scene.motions[0].interpolation == casefile::Interpolation::smooth);
}

TEST_CASE("a history file that does not fit is refused with what would") {
  const ScratchFolder folder;
  const std::string key = "history_file = \"record.csv\"\n";
  const auto refused = [&](const std::string& text, const std::string& tables, const std::string& words) {
    CAPTURE(words);
    write(folder, text);
    CHECK(refusal(folder, tables).find(words) != std::string::npos);
  };
  refused("time_s,force_N\n0,0\n", motion + key, "give the columns time_s and displacement_mm");
  refused("time_s,displacement_mm\n0,0\n", load + key, "give the columns time_s and force_N");
  refused("time_s,force_N,x\n0,0,1\n", load + key, "the file has the columns time_s, force_N, x");
  refused("time_s,force_N\n", load + key, "the file has no rows");
  refused("time_s,force_N\n0,0\n1,2\n1,3\n", load + key, "row 3: its time does not come after");
  refused("time_s,force_N\n0,0\n1,nan\n", load + key, "line 3");
  refused("time_s,force_N\n0,0\n", load + key + "history = [[0, 0]]\n", "excludes");
  refused("", load, "one of `history`, `history_file` is missing");
  CHECK(message_of<FileError>([&] { read(folder, load + "history_file = \"none.csv\"\n"); }).find("none.csv") !=
        std::string::npos);
}

TEST_CASE("a history file of 160000 rows is read in less than a second or two") {
  const ScratchFolder folder;
  std::string rows = "time_s,force_N\n";
  for (int i = 0; i < 160000; ++i) rows += fmt::format("{},{}\n", 1e-4 * i, i % 17);
  write(folder, rows);
  const auto begin = std::chrono::steady_clock::now();
  CHECK(read(folder, load + "history_file = \"record.csv\"\n").loads[0].history.size() == 160000);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));  // what a quadratic reader is far beyond
}

TEST_CASE(
    "a record with a clock of its own, uneven steps and a gap is the signal that was sampled, and says what it is") {
  const ScratchFolder folder;
  const auto signal = [](double t) { return 20 * std::sin(2 * 3.14159265358979 * 5 * t); };  // [N] at 5 Hz
  std::string text = "time_s,force_N\n";
  double t = 0;
  for (int i = 0; t < 2; ++i) {
    text += fmt::format("{},{}\n", 36000 + t, signal(t));
    t += 0.004 + 0.002 * (i % 3) / 2;  // 4, 5 and 6 ms
    if (i == 150) t += 0.026;          // a gap
  }
  write(folder, text);
  const casefile::Scene scene =
      read(folder, load + "history_file = \"record.csv\"\ninterpolation = \"smooth\"\nhistory_begins_at_s = 36000\n");
  const math::TimeFunction history = scene.loads[0].history_function();
  for (double at = 0.05; at < 1.9; at += 0.0137) {
    test::check_close(math::evaluate(history, at), signal(at), {.absolute = 0.05});
  }
  REQUIRE(scene.notes.size() == 1);
  CHECK(scene.notes[0].find("1 gap in the rows") != std::string::npos);
  const casefile::Scene late = read(folder, load + "history_file = \"record.csv\"\n");
  REQUIRE(late.notes.size() == 2);
  CHECK(late.notes[1].find("begins at 36000 s") != std::string::npos);
}
