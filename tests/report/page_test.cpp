#include "strandyn/report/page.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "report/markup.hpp"
#include "results/scratch_folder.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/report/figures.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/table.hpp"

using nlohmann::ordered_json;
using strandyn::FileError;
using strandyn::InputError;
using strandyn::report::write_report;
using strandyn::results::read_file;
using strandyn::results::Table;
using strandyn::results::write_csv;
using strandyn::results::write_file;
using strandyn::results::write_json;
using strandyn::test::contains;
using strandyn::test::count_of;
using strandyn::test::find_markup_fault;
using strandyn::test::message_of;
using strandyn::test::ScratchFolder;

namespace {

ordered_json forced_summary(int cycles) {
  ordered_json summary = {{"title", "Curlew <30 m> & shaker"},
                          {"status", "done"},
                          {"program", {{"version", "0.1.0"}, {"compiler", "GNU 12.2.0"}}},
                          {"section", {{"EA_N", 4.71459e7}, {"EI_max_N_m2", 2387.42}}},
                          {"cost", {{"wall_s", 12.5}, {"steps", 40000}}},
                          {"warnings", {"drive is off <resonance>"}},
                          {"cycles", ordered_json::array()}};
  summary["case"] = {{"title", "x"},
                     {"conductor", {{"catalogue", "curlew"}}},
                     {"span", {{"length_m", 30}, {"tension_kN", 24.42}}},
                     {"load", {{{"type", "harmonic-force"}, {"at_m", 0.7}, {"direction", {0, 1, 0}}}}},
                     {"analysis", {{"type", "forced"}}}};
  for (int i = 1; i <= cycles; ++i) {
    summary["cycles"].push_back({{"t_s", i / 24.0},
                                 {"antinode_amplitude_m", 1e-3 * i},
                                 {"external_work_J", 0.1 * i},
                                 {"kinetic_J", 0.5},
                                 {"elastic_J", 0.2},
                                 {"friction_dissipation_J", 0.08 * i},
                                 {"viscous_dissipation_J", 0.0},
                                 {"numerical_dissipation_J", 0.001 * i},
                                 {"quadrature_error_J", 0.0},
                                 {"elements_slipping", i}});
  }
  summary["steady"] = {{"antinode_amplitude_m", 8.4e-3}, {"numerical_share", 0.0125}, {"self_damping_W_per_m", 1.1e-3}};
  return summary;
}

/// Loss and curvature falling off exponentially from both ends of 30 m, over `length` [m].
Table profile(double length) {
  Table table({"x_m", "friction_J_per_m", "curvature_amplitude_per_m"});
  for (int i = 0; i <= 3000; ++i) {
    const double x = 0.01 * i;
    const double near = std::exp(-x / length) + std::exp(-(30 - x) / length);
    table.append(std::vector{x, 0.6 * near, 0.07 * near});
  }
  return table;
}

Table loops() {
  Table table({"loop", "tension_N", "curvature_per_m", "moment_N_m"});
  for (int loop = 1; loop <= 2; ++loop) {
    for (int i = 0; i <= 60; ++i) {
      const double angle = std::numbers::pi * i / 30;
      table.append(std::vector{1.0 * loop, 24420.0 * loop, 0.05 * std::cos(angle), 100 * std::sin(angle)});
    }
  }
  return table;
}

}  // namespace

TEST_CASE("page: a full folder becomes one page that needs nothing beside it, and its plots become files") {
  const ScratchFolder folder;
  write_json(folder / "summary.json", forced_summary(50));
  write_csv(folder / "dissipation_profile.csv", profile(0.2));
  write_csv(folder / "loop.csv", loops());
  const auto path = write_report(folder.path());
  CHECK(path == folder / "report.html");
  const std::string page = read_file(path);
  CHECK(find_markup_fault(page) == "");
  CHECK(count_of(page, "<svg") == 6);
  for (const char* outside : {"href", "src=", "<script", "url(", "@import"}) CHECK_FALSE(contains(page, outside));
  for (const char* shown :
       {"<h1>Curlew &lt;30 m&gt; &amp; shaker</h1>", "drive is off &lt;resonance&gt;", "Key numbers", "8.400", "1.100",
        "mW/m", "1.25", "Hysteresis of the cross section", "Energy per cycle", "Antinode amplitude",
        "Where the energy is lost along the span", "20 of 50 cycles.", "47.15", "tension_kN", "24.42", "harmonic-force",
        "[0, 1, 0]", "GNU 12.2.0", "40000"}) {
    INFO(shown);
    CHECK(contains(page, shown));
  }
  for (const char* name : {"loops", "energy_per_cycle", "amplitude", "dissipation_profile"}) {
    INFO(name);
    const std::string plot = read_file(folder / (std::string(name) + ".svg"));
    CHECK(find_markup_fault(plot) == "");
    CHECK(contains(plot, "<path"));
  }
}

TEST_CASE("page: missing files and missing parts of the summary just mean fewer sections") {
  const ScratchFolder folder;
  write_json(folder / "summary.json", ordered_json::object());
  const std::string page = read_file(write_report(folder.path()));
  CHECK(find_markup_fault(page) == "");
  CHECK(contains(page, "<h1>Results</h1>"));
  CHECK_FALSE(contains(page, "<section"));
  CHECK(folder.entries() == 2);
}

TEST_CASE("page: values of an unexpected kind do no harm") {
  const ScratchFolder folder;
  ordered_json summary = {{"title", 7},       {"status", nullptr}, {"case", "none"},   {"warnings", "none"},
                          {"cycles", {1, 2}}, {"steady", {1}},     {"section", false}, {"points", {{{"road", 3}}}}};
  write_json(folder / "summary.json", summary);
  CHECK(find_markup_fault(read_file(write_report(folder.path()))) == "");
}

TEST_CASE("page: where the summary has no cycles they come from cycles.csv") {
  const ScratchFolder folder;
  auto summary = forced_summary(0);
  write_json(folder / "summary.json", summary);
  Table cycles({"t_s", "external_work_J", "friction_dissipation_J", "numerical_dissipation_J"});
  for (int i = 1; i <= 3; ++i) cycles.append(std::vector{0.1 * i, 1.0, 0.9, 0.01});
  write_csv(folder / "cycles.csv", cycles);
  const std::string page = read_file(write_report(folder.path()));
  CHECK(contains(page, "Energy of each cycle"));
  CHECK(std::filesystem::exists(folder / "energy_per_cycle.svg"));
  CHECK_FALSE(std::filesystem::exists(folder / "amplitude.svg"));
}

TEST_CASE("page: parts of the summary that it does not know by name are shown all the same") {
  const ScratchFolder folder;
  ordered_json summary = {{"chi_0_per_m", 0.032618},
                          {"frequencies_Hz", {1.85, 3.7}},
                          {"fixed_end", {{"seed", {{"k1_N", 1.3853e7}}}}},
                          {"loops", {{{"curvature_per_m", 0.05}, {"area_J_per_m", 1.25e-2}}}}};
  write_json(folder / "summary.json", summary);
  const std::string page = read_file(write_report(folder.path()));
  for (const char* shown : {"0.03262", "3.700", "13.85", "seed.k1", "12.50", "mJ/m"}) {
    INFO(shown);
    CHECK(contains(page, shown));
  }
}

TEST_CASE("page: a folder without a summary is a file error that says what to give") {
  const ScratchFolder folder;
  CHECK(message_of<FileError>([&] { write_report(folder.path()); }) ==
        "there is no " + (folder / "summary.json").string() + ": give the folder that `strandyn run` wrote");
  CHECK(message_of<FileError>([&] { write_report(folder / "none"); }).starts_with("there is no "));
}

TEST_CASE("page: a broken file is an input error that says where and what to do") {
  const ScratchFolder folder;
  write_file(folder / "summary.json", "{\"title\": \"cut o");
  const auto message = message_of<InputError>([&] { write_report(folder.path()); });
  CHECK(message.starts_with((folder / "summary.json").string() + ": parse error at line 1, column "));
  CHECK(message.ends_with("; run the case again to write it anew"));
  write_file(folder / "summary.json", "[1, 2]");
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "expected a JSON object at the top"));
  write_file(folder / "summary.json", "{}");
  write_file(folder / "loop.csv", "loop,tension_N\n1,x\n");
  CHECK(contains(message_of<InputError>([&] { write_report(folder.path()); }), "loop.csv, line 2: column tension_N"));
}

TEST_CASE("figures: half of a loss that falls off exponentially lies within length times log 2") {
  // 0.2 m * log 2 = 0.1386 m on each side, 0.92 % of 30 m.
  const auto figure = strandyn::report::dissipation_figure(profile(0.2));
  REQUIRE(figure.has_value());
  CHECK(contains(figure->caption, "Half of it lies within 139 mm of the supports, on 0.92 % of the length."));
  CHECK(strandyn::report::dissipation_near_support_figure(profile(0.2)).has_value());
  // Half of the loss on more than a tenth of the length: one plot shows it.
  CHECK_FALSE(strandyn::report::dissipation_near_support_figure(profile(3)).has_value());
}

TEST_CASE("figures: the distance is counted from the supports, not from the outermost section points") {
  // A uniform loss on 10 m, known at midpoints of metres: half of it lies within 2.5 m of the ends.
  Table table({"x_m", "friction_J_per_m"});
  for (int i = 0; i < 10; ++i) table.append(std::vector{0.5 + i, 0.3});
  const auto figure = strandyn::report::dissipation_figure(table);
  REQUIRE(figure.has_value());
  CHECK(contains(figure->caption, "Half of it lies within 2.5 m of the supports, on 50 % of the length."));
}

TEST_CASE("figures: a span without loss has a profile and no half of it") {
  Table table({"x_m", "friction_J_per_m"});
  for (const double x : {0.0, 15.0, 30.0}) table.append(std::vector{x, 0.0});
  const auto figure = strandyn::report::dissipation_figure(table);
  REQUIRE(figure.has_value());
  CHECK_FALSE(contains(figure->caption, "Half"));
  CHECK_FALSE(strandyn::report::dissipation_near_support_figure(table).has_value());
  CHECK_FALSE(strandyn::report::curvature_figure(table).has_value());
}

TEST_CASE("figures: a loop is named by what sets it apart") {
  const auto by_tension = strandyn::report::loops_figure(loops());
  REQUIRE(by_tension.has_value());
  CHECK(by_tension->plot.series.at(0).name == "24.4 kN");
  CHECK(by_tension->plot.series.at(1).name == "48.8 kN");

  Table same_tension({"loop", "tension_N", "curvature_per_m", "moment_N_m"});
  for (const double amplitude : {0.02, 0.05}) {
    same_tension.append(std::vector{amplitude, 24420.0, amplitude, 1.0});
    same_tension.append(std::vector{amplitude, 24420.0, -amplitude, -1.0});
  }
  const auto by_amplitude = strandyn::report::loops_figure(same_tension);
  REQUIRE(by_amplitude.has_value());
  CHECK(by_amplitude->plot.series.at(0).name == "±0.020 1/m");
  CHECK(by_amplitude->plot.series.at(1).name == "±0.050 1/m");
}

TEST_CASE("figures: the numerical part is drawn even where it is zero, an absent viscous part is not") {
  auto cycles = forced_summary(3)["cycles"];
  for (auto& cycle : cycles) cycle["numerical_dissipation_J"] = 0.0;
  const auto figure = strandyn::report::energy_figure(strandyn::report::cycle_rows(cycles));
  REQUIRE(figure.has_value());
  std::vector<std::string> names;
  for (const auto& series : figure->plot.series) names.push_back(series.name);
  CHECK(names == std::vector<std::string>{"external work", "friction", "numerical"});
}

TEST_CASE("figures: self-damping has one line per tension, and the road where roads differ") {
  auto points = ordered_json::array();
  for (const char* road : {"quadrature", "foti-2018"}) {
    for (const double f : {10.0, 20.0}) {
      points.push_back(
          {{"frequency_Hz", f}, {"tension_N", 24420.0}, {"road", road}, {"self_damping_W_per_m", 1e-3 * f}});
    }
  }
  const auto figure = strandyn::report::self_damping_figure(points);
  REQUIRE(figure.has_value());
  REQUIRE(figure->plot.series.size() == 2);
  CHECK(figure->plot.series[0].name == "24.4 kN, foti-2018");
  CHECK(figure->plot.series[1].x == std::vector{10.0, 20.0});
  for (auto& point : points) point["road"] = "quadrature";
  CHECK(strandyn::report::self_damping_figure(points)->plot.series[0].name == "24.4 kN");
}
