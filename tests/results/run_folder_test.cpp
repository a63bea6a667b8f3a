#include "strandyn/results/run_folder.hpp"

#include <doctest/doctest.h>

#include "results/scratch_folder.hpp"
#include "results/small_run.hpp"
#include "strandyn/core/error.hpp"

using strandyn::FileError;
using strandyn::InputError;
using strandyn::results::Figure;
using strandyn::results::read_run_folder;
using strandyn::results::Value;
using strandyn::results::write_file;
using strandyn::test::message_of;
using strandyn::test::ScratchFolder;
using strandyn::test::SmallRun;
using strandyn::test::table_of_rows;

TEST_CASE("run folder: what a run declares comes back as it was declared") {
  const ScratchFolder scratch;
  SmallRun run;
  run.highlights = {{.name = "loss factor", .path = "steady.loss_factor", .value = 0.125}};
  run.figures = {{.name = "loops",
                  .title = "Loops",
                  .kind = "band",
                  .table = "loop.csv",
                  .x = "curvature_per_m",
                  .y = {"low_N_m", "high_N_m"},
                  .series = {"tension_N"},
                  .x_scale = "log",
                  .caption = "The area is the loss.",
                  .x_range = {{0.5, 2}}}};
  run.shown = {{.title = "Loops", .table = "loop.csv", .columns = {"tension_N"}}};
  run.tables = {{"loop.csv", table_of_rows({"tension_N"}, {{1}, {2}})}};
  run.more = Value::object({{"message", "stopped"}, {"steady", Value::object({{"loss_factor", 0.125}})}});
  run.write(scratch.path());

  auto read = read_run_folder(scratch.path());
  CHECK(read.title == "Curlew <30 m> & shaker");
  CHECK(read.status == "done");
  CHECK(read.message == "stopped");
  CHECK(read.analysis == "forced");
  CHECK(read.facts == std::vector<std::string>{"conductor curlew", "30 m span", "24.42 kN", "section law return-map"});
  CHECK(read.warnings == std::vector<std::string>{"drive is off <resonance>"});
  REQUIRE(read.highlights.size() == 1);
  CHECK(read.highlights[0].path == "steady.loss_factor");
  CHECK(read.highlights[0].value == 0.125);
  REQUIRE(read.figures.size() == 1);
  CHECK(to_text(to_value(read.figures[0])) == to_text(to_value(run.figures[0])));
  REQUIRE(read.shown.size() == 1);
  CHECK(read.shown[0].columns == run.shown[0].columns);
  CHECK(read.section.find("EA_N")->number() == 4.71459e7);
  CHECK(read.table("loop.csv").column("tension_N") == std::vector{1.0, 2.0});
  REQUIRE(read.rest.members().size() == 1);
  CHECK(read.rest.members()[0].first == "steady");
}

TEST_CASE("run folder: a table that is named and not there, or lies elsewhere, is refused by name") {
  const ScratchFolder scratch;
  SmallRun().write(scratch.path());
  auto run = read_run_folder(scratch.path());
  CHECK(message_of<InputError>([&] { run.table("cycles.csv"); }) ==
        "there is no " + (scratch / "cycles.csv").string() + ", which " + (scratch / "summary.json").string() +
            " names; run the case again to write it anew");
  CHECK(message_of<InputError>([&] { run.table("../summary.json"); }).starts_with("there is no "));
}

TEST_CASE("run folder: no summary is a file error, a broken one an input error with the remedy") {
  const ScratchFolder scratch;
  CHECK(message_of<FileError>([&] { read_run_folder(scratch.path()); }) ==
        "there is no " + (scratch / "summary.json").string() + ": give the folder that `strandyn run` wrote");
  const auto fault = [&](const std::string& text) {
    write_file(scratch / "summary.json", text);
    return message_of<InputError>([&] { read_run_folder(scratch.path()); });
  };
  const std::string file = (scratch / "summary.json").string();
  CHECK(fault("{\"title\": \"cut o").starts_with(file + ": parse error at line 1, column "));
  CHECK(fault("{\"title\": \"cut o").ends_with("; run the case again to write it anew"));
  CHECK(fault("[1, 2]") ==
        file + ": not a summary: expected a JSON object at the top; run the case again to write it anew");
  CHECK(fault("{\"figures\": 3}") == file + ": figures is a number, not a list; run the case again to write it anew");
  CHECK(fault("{\"figures\": [{\"name\": \"loops\"}]}") ==
        file + ": figures[0] is incomplete; run the case again to write it anew");
  const std::string outside = R"({"figures": [{"name": "../loops", "table": "a.csv", "x": "a", "y": ["b"]}]})";
  CHECK(fault(outside).starts_with(file + ": figures[0] is incomplete"));
  CHECK(fault("{\"shown_tables\": [{}]}").starts_with(file + ": shown_tables[0] is incomplete"));
  CHECK(fault("{\"highlights\": [1]}").starts_with(file + ": highlights[0] is incomplete"));
}

TEST_CASE("run folder: words and objects of an unexpected kind are left empty") {
  const ScratchFolder scratch;
  write_file(scratch / "summary.json",
             R"({"title": 7, "status": null, "case": "none", "section": false, "warnings": ["a", {"b": 1}]})");
  const auto run = read_run_folder(scratch.path());
  CHECK(run.title.empty());
  CHECK(run.the_case.is_null());
  CHECK(run.facts.empty());
  CHECK(run.warnings == std::vector<std::string>{"a", "{\"b\":1}"});
  CHECK(run.figures.empty());
}
