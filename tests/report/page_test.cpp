#include "strandyn/report/page.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "report/markup.hpp"
#include "results/scratch_folder.hpp"
#include "results/small_run.hpp"
#include "strandyn/core/error.hpp"

using strandyn::FileError;
using strandyn::InputError;
using strandyn::report::write_report;
using strandyn::results::read_file;
using strandyn::results::Table;
using strandyn::results::Value;
using strandyn::results::write_file;
using strandyn::test::contains;
using strandyn::test::count_of;
using strandyn::test::find_markup_fault;
using strandyn::test::message_of;
using strandyn::test::ScratchFolder;
using strandyn::test::SmallRun;

namespace {

/// A forced run: cycles, a profile, and what they say of themselves.
SmallRun forced_run(int cycles) {
  SmallRun run;
  Table ledger({"cycle", "t_s", "antinode_amplitude_m", "external_work_J", "friction_dissipation_J",
                "numerical_dissipation_J", "numerical_share"});
  Value list = Value::list();
  for (int i = 1; i <= cycles; ++i) {
    ledger.append(std::vector{1.0 * i, i / 24.0, 1e-3 * i, 0.1 * i, 0.08 * i, 0.001 * i, 0.0125});
    list.append(Value::object({{"t_s", i / 24.0}, {"kinetic_J", 0.5}}));
  }
  Table profile({"x_m", "friction_J_per_m"});
  for (int i = 0; i <= 3000; ++i) {
    const double x = 0.01 * i;
    profile.append(std::vector{x, 0.6 * (std::exp(-x / 0.2) + std::exp(-(30 - x) / 0.2))});
  }
  run.tables = {{"cycles.csv", ledger}, {"dissipation_profile.csv", profile}};
  run.figures = {{.name = "energy_per_cycle",
                  .title = "Energy per cycle",
                  .table = "cycles.csv",
                  .x = "cycle",
                  .y = {"external_work_J", "friction_dissipation_J", "numerical_dissipation_J"},
                  .caption = "Where the <work> of a cycle goes."},
                 {.name = "dissipation_profile",
                  .title = "Where the energy is lost along the span",
                  .table = "dissipation_profile.csv",
                  .x = "x_m",
                  .y = {"friction_J_per_m"}}};
  run.shown = {{.title = "Energy of each cycle",
                .table = "cycles.csv",
                .columns = {"cycle", "t_s", "external_work_J", "numerical_share"}}};
  run.highlights = {{.name = "antinode amplitude", .path = "steady.antinode_amplitude_m", .value = 8.4e-3},
                    {.name = "self-damping", .path = "steady.self_damping_W_per_m", .value = 1.113e-3},
                    {.name = "numerical share", .path = "steady.numerical_share", .value = 0.0125}};
  run.more = Value::object({{"cycles", list},
                            {"steady", Value::object({{"antinode_amplitude_m", 8.4e-3},
                                                      {"numerical_share", 0.0125},
                                                      {"self_damping_W_per_m", 1.113e-3},
                                                      {"loss_factor", 0.0777}})}});
  return run;
}

/// The page as it is where no script runs: what draws its plots anew is a program of its own.
std::string without_scripts(std::string page) {
  for (auto from = page.find("<script"); from != std::string::npos; from = page.find("<script", from)) {
    page.erase(from, page.find("</script>", from) + 9 - from);
  }
  return page;
}

std::string page_of(const SmallRun& run, const ScratchFolder& folder) {
  run.write(folder.path());
  std::string page = without_scripts(read_file(write_report(folder.path())));
  CHECK(find_markup_fault(page) == "");
  return page;
}

}  // namespace

TEST_CASE("page: a full folder becomes one page that needs nothing beside it, and its figures become files") {
  const ScratchFolder folder;
  const std::string page = page_of(forced_run(50), folder);
  CHECK(count_of(page, "<svg") == 2);
  for (const char* outside : {"href", "src=", "<script", "url(", "@import"}) CHECK_FALSE(contains(page, outside));
  for (const char* shown :
       {"<h1>Curlew &lt;30 m&gt; &amp; shaker</h1>", "<li>30 m span</li>", "drive is off &lt;resonance&gt;",
        "Key numbers", "8.400", "1.113", "mW/m", "1.25", "Energy per cycle", "Where the &lt;work&gt; of a cycle goes.",
        "Where the energy is lost along the span", "47.15", "tension_kN", "24.42", "harmonic-force", "[0, 1, 0]",
        "GNU 12.2.0", "40000"}) {
    INFO(shown);
    CHECK(contains(page, shown));
  }
  for (const char* name : {"energy_per_cycle.svg", "dissipation_profile.svg"}) {
    const std::string plot = read_file(folder / name);
    CHECK(find_markup_fault(plot) == "");
    CHECK(contains(plot, "<path"));
  }
}

TEST_CASE("page: a table is whole, or says how many rows it leaves out and where all are") {
  const ScratchFolder folder;
  CHECK_FALSE(contains(page_of(forced_run(50), folder), "left out"));
  const std::string page = page_of(forced_run(200), folder);
  CHECK(contains(page,
                 "60 of 200 rows, evenly spaced; 140 are left out. All are in <a href=\"cycles.csv\">cycles.csv</a>."));

  SmallRun run;
  Value points = Value::list(), numbers = Value::list();
  for (int i = 0; i < 61; ++i) {
    points.append(Value::object({{"amplitude_m", 0.001 * i}}));
    numbers.append(0.5 * i);
  }
  run.more = Value::object({{"points", points}, {"frequencies_Hz", numbers}});
  CHECK(count_of(page_of(run, folder),
                 "60 of 61 rows, evenly spaced; 1 are left out. All are in <a href=\"summary.json\">") == 2);
}

TEST_CASE("page: what stands in a card or in a shown table is not shown again") {
  const ScratchFolder folder;
  const std::string page = page_of(forced_run(50), folder);
  CHECK(count_of(page, "8.400") == 1);
  CHECK(count_of(page, "1.113") == 1);
  CHECK(contains(page, "0.07770"));  // what no card has
  CHECK_FALSE(contains(page, "kinetic"));
  for (const char* key : {"highlights", "shown tables", "figures<", "antinode_amplitude_m"}) {
    INFO(key);
    CHECK_FALSE(contains(page, key));
  }
}

TEST_CASE("page: a summary that describes nothing still gives a page") {
  const ScratchFolder folder;
  write_file(folder / "summary.json", "{}");
  const std::string page = without_scripts(read_file(write_report(folder.path())));
  CHECK(find_markup_fault(page) == "");
  CHECK(contains(page, "<h1>Results</h1>"));
  CHECK_FALSE(contains(page, "<section"));
  CHECK(folder.entries() == 2);
}

TEST_CASE("page: values of an unexpected kind do no harm") {
  const ScratchFolder folder;
  write_file(folder / "summary.json",
             R"({"title": 7, "status": null, "case": "none", "warnings": "none", "cycles": [1, 2], "steady": [1],
                 "section": false, "points": [{"road": 3}], "empty": [], "deep": [[1, [2]], {"a": null}]})");
  CHECK(find_markup_fault(without_scripts(read_file(write_report(folder.path())))) == "");
}

TEST_CASE("page: a run that ended before its first cycle has no empty plots and tables") {
  const ScratchFolder folder;
  auto run = forced_run(0);
  run.more.set("message", "interrupted at t = 0.01 s");
  const std::string page = page_of(run, folder);
  CHECK(count_of(page, "<svg") == 1);
  CHECK(contains(page, "interrupted at t = 0.01 s"));
  CHECK_FALSE(contains(page, "Energy of each cycle"));
  CHECK_FALSE(std::filesystem::exists(folder / "energy_per_cycle.svg"));
}

TEST_CASE("page: whatever else the summary holds becomes a list or a table") {
  const ScratchFolder folder;
  SmallRun run;
  const auto k1 = Value::object({{"k1_N", 1.3853e7}, {"slip_share", 0.25}});
  run.more = Value::object(
      {{"chi_0_per_m", 0.032618},
       {"frequencies_Hz", Value::list({1.85, 3.7})},
       {"fixed_end", Value::object({{"seed", k1}, {"rows", Value::list({Value::object({{"turns", 77}})})}})},
       {"loops", Value::list({Value::object({{"curvature_per_m", 0.05},
                                             {"area_J_per_m", 1.25e-2},
                                             {"state", Value::object({{"force_N", 2500.0}})}})})}});
  const std::string page = page_of(run, folder);
  for (const char* shown : {"0.03262", "3.700", "13.85", "seed.k1", "seed.slip share", "25.0", "12.50", "mJ/m",
                            "<h4>rows</h4>", "77", "state.force", "2.500"}) {
    INFO(shown);
    CHECK(contains(page, shown));
  }
}

TEST_CASE("page: a figure or a shown table without its file or column is refused, and no page is written") {
  const ScratchFolder folder;
  auto run = forced_run(3);
  run.figures[0].y.push_back("heat_J");
  run.write(folder.path());
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "asks for the column 'heat_J'"));
  run = forced_run(3);
  run.figures[1].table = "gone.csv";
  run.write(folder.path());
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "gone.csv"));
  run = forced_run(3);
  run.shown[0].columns.push_back("heat_J");
  run.write(folder.path());
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "asks for the column 'heat_J'"));
  CHECK_FALSE(std::filesystem::exists(folder / "report.html"));
}

TEST_CASE("page: a folder without a summary is a file error, a broken table an input error with its line") {
  const ScratchFolder folder;
  CHECK(message_of<FileError>([&] { write_report(folder.path()); }) ==
        "there is no " + (folder / "summary.json").string() + ": give the folder that `strandyn run` wrote");
  CHECK(message_of<FileError>([&] { write_report(folder / "none"); }).starts_with("there is no "));
  forced_run(3).write(folder.path());
  write_file(folder / "cycles.csv", "cycle,t_s\n1,x\n");
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "cycles.csv, line 2: column t_s"));
}
