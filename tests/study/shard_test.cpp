#include "strandyn/study/shard.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "results/scratch_folder.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "study/self_damping_scene.hpp"

using namespace strandyn;
using study::Shard;

namespace {

/// Two tensions of four quadrature points each, and as many points by the closed form as are asked for.
casefile::Scene mixed_scene(int closed_forms) {
  std::string text = "frequencies_Hz = [10, 30]\namplitude_over_diameter = [0.1, 0.4]\ntensions_rts = [0.15, 0.25]\n";
  for (int i = 0; i < closed_forms; ++i) {
    text += fmt::format(
        "[[analysis.at]]\nmethod = \"foti-2018\"\nfrequency_Hz = {}\namplitude_over_diameter = 0.1\n"
        "tension_rts = 0.2\n",
        10 + i);
  }
  return test::damping_scene("return-map", text);
}

}  // namespace

TEST_CASE("shard: each point is in one shard, and no shard is empty while there are points enough") {
  for (const int closed_forms : {0, 1, 3, 10}) {
    const casefile::Scene scene = mixed_scene(closed_forms);
    const auto analysis = study::prepare(scene);
    const study::Pieces& pieces = *analysis->pieces();
    REQUIRE(pieces.count() == 8 + static_cast<std::size_t>(closed_forms));
    for (std::size_t of = 1; of <= pieces.count() + 3; ++of) {
      CAPTURE(of);
      std::vector<int> times(pieces.count(), 0);
      for (std::size_t number = 1; number <= of; ++number) {
        const auto share = pieces.share({.number = number, .of = of});
        CHECK(std::ranges::is_sorted(share));
        CHECK((of > pieces.count() || !share.empty()));
        for (const std::size_t place : share) ++times[place];
      }
      CHECK(times == std::vector<int>(pieces.count(), 1));
    }
  }
}

TEST_CASE("shard: points of one table stay together, others are dealt so that a repeating grid is mixed") {
  const casefile::Scene scene = mixed_scene(0);
  const auto analysis = study::prepare(scene);
  CHECK(analysis->pieces()->share({.number = 1, .of = 2}) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(analysis->pieces()->share({.number = 2, .of = 2}) == std::vector<std::size_t>{4, 5, 6, 7});
  // A grid of three columns: no shard of three gets one column.
  CHECK(study::dealt(9, {.number = 1, .of = 3}) == std::vector<std::size_t>{0, 5, 7});
  CHECK(study::dealt(9, {.number = 2, .of = 3}) == std::vector<std::size_t>{1, 3, 8});
  CHECK(study::dealt(9, {.number = 3, .of = 3}) == std::vector<std::size_t>{2, 4, 6});
}

TEST_CASE("shard: what is no I of N is refused") {
  CHECK(study::parse_shard("2/3") == Shard{.number = 2, .of = 3});
  for (const char* wrong : {"0/3", "4/3", "1/0", "1", "1/2/3", "a/b", "-1/3", "1/", "/2", "", "1 /3", "1/3 ",
                            "99999999999999999999999/3", "+1/3", "1.0/2"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(study::parse_shard(wrong), InputError);
  }
}

TEST_CASE("shard: a shard computes its own points and tables, and what a stopped study has kept is not made again") {
  const casefile::Scene scene = mixed_scene(2);
  const test::ScratchFolder folder;
  const auto part = study::run_case(
      scene, {.stop = {}, .progress = {}, .folder = folder.path(), .shard = Shard{.number = 2, .of = 2}});
  CHECK(part.exit_code == ExitCode::done);
  CHECK(part.summary.find("points")->entries().size() == 5);
  CHECK(part.summary.find("fit") == nullptr);
  const std::string log = results::read_file(folder / "points.jsonl");
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t times = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
    return times;
  };
  CHECK(count(log, "\"table\"") == 1);

  // The whole study goes on from there: the table of the shard's tension costs nothing more, and the file is that of a
  // study which was never divided.
  const test::ScratchFolder whole;
  const auto all = study::run_case(scene, {.stop = {}, .progress = {}, .folder = whole.path()});
  const auto rest =
      study::run_case(scene, {.stop = {}, .progress = {}, .folder = folder.path(), .resume = true, .merged = true});
  CHECK(results::read_file(folder / "points.jsonl") == results::read_file(whole / "points.jsonl"));
  CHECK(count(results::read_file(whole / "points.jsonl"), "\"table\"") == 2);
  CHECK(rest.cost.section_evaluations == all.cost.section_evaluations);
}
