#include "strandyn/report/figures.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "report/markup.hpp"
#include "results/scratch_folder.hpp"
#include "results/small_run.hpp"
#include "strandyn/core/error.hpp"

using strandyn::InputError;
using strandyn::report::Colour;
using strandyn::report::Plot;
using strandyn::report::plot_of;
using strandyn::report::svg;
using strandyn::results::Figure;
using strandyn::results::Table;
using strandyn::test::contains;
using strandyn::test::count_of;
using strandyn::test::find_markup_fault;
using strandyn::test::message_of;
using strandyn::test::table_of_rows;

namespace {

using Names = std::vector<std::string>;

Figure figure(std::string x, Names y) {
  return {.name = "f", .title = "F", .table = "t.csv", .x = std::move(x), .y = std::move(y)};
}

Names names_of(const Plot& plot) {
  Names names;
  for (const auto& line : plot.series) names.push_back(line.name);
  return names;
}

Plot plot(const Figure& f, const Table& table) {
  const auto drawn = plot_of(f, table);
  REQUIRE(drawn.has_value());
  return *drawn;
}

/// Two closed loops at each of the tensions, the rows of the second tension first.
Table loops(double second_tension) {
  Table table({"loop", "tension_N", "amplitude_per_m", "curvature_per_m", "moment_N_m"});
  for (const double tension : {second_tension, 24420.0}) {
    for (const double amplitude : {0.02, 0.05}) {
      for (const double sign : {1.0, -1.0, 1.0}) {
        const double number = (tension == 24420 ? 1 : 3) + (amplitude > 0.03);
        table.append(std::vector{number, tension, amplitude, sign * amplitude, sign});
      }
    }
  }
  return table;
}

Table ledger() {
  return table_of_rows({"cycle", "external_work_J", "friction_dissipation_J", "viscous_dissipation_J", "air_drag_J",
                        "numerical_dissipation_J"},
                       {{1, 0.1, 0.08, 0, 0.01, 0}, {2, 0.2, 0.16, 0, 0.02, 0}, {3, 0.3, 0.24, 0, 0.03, 0}});
}

}  // namespace

TEST_CASE("figures: every kind draws") {
  const Table table = table_of_rows({"theta_rad", "layer", "low_N", "high_N"},
                                    {{0, 1, 1, 2}, {1, 1, 2, 4}, {0, 2, 3, 5}, {1, 2, 1, 3}});
  for (const char* kind : {"line", "band", "map", "section", "motion"}) {
    INFO(kind);
    auto f = figure("theta_rad", {"layer", "high_N"});
    f.kind = kind;
    const std::string text = svg(plot(f, table));
    CHECK(find_markup_fault(text) == "");
    CHECK(count_of(text, "<path") >= 2);
    CHECK(contains(text, ">angle around the lay (rad)</text>"));
  }
}

TEST_CASE("figures: what a figure asks for and does not get is refused by name") {
  const Table table = table_of_rows({"a", "b"}, {{1, 2}, {2, 3}});
  const auto fault = [&](const Figure& f) { return message_of<InputError>([&] { plot_of(f, table); }); };
  CHECK(fault(figure("a", {"c"})) == "the figure 'f' of summary.json asks for the column 'c' of t.csv, which has a, b");
  CHECK(contains(fault(figure("x", {"b"})), "asks for the column 'x'"));
  auto f = figure("a", {"b"});
  f.series = {"s"};
  CHECK(contains(fault(f), "asks for the column 's'"));
  f = figure("a", {"b"});
  f.kind = "pie";
  CHECK(
      fault(f) ==
      "the figure 'f' of summary.json is of the kind 'pie'; there are line, points, band, map, section, motion, wires");
  f.kind = "band";
  CHECK(contains(fault(f), "is a band of 1 columns; it takes the low and the high one"));
  f.kind = "line";
  f.y_scale = "cubic";
  CHECK(contains(fault(f), "has the scale 'cubic'; there are linear and log"));
}

TEST_CASE("figures: lines are told apart by the values that differ, in ascending order") {
  auto f = figure("curvature_per_m", {"moment_N_m"});
  f.series = {"loop", "tension_N", "amplitude_per_m"};
  CHECK(names_of(plot(f, loops(48840))) ==
        Names{"24.4 kN, ±0.02 1/m", "24.4 kN, ±0.05 1/m", "48.8 kN, ±0.02 1/m", "48.8 kN, ±0.05 1/m"});
  CHECK(names_of(plot(f, loops(24420.1))) ==
        Names{"24.42 kN, ±0.02 1/m", "24.42 kN, ±0.05 1/m", "24.4201 kN, ±0.02 1/m", "24.4201 kN, ±0.05 1/m"});
  f.series = {"loop"};
  CHECK(names_of(plot(f, loops(48840))) == Names{"loop 1", "loop 2", "loop 3", "loop 4"});
  const Plot drawn = plot(f, loops(48840));
  CHECK(drawn.series[0].custom_colour == "#2f7fd1");
  CHECK(drawn.series[3].custom_colour == "#e07e2b");
  CHECK(drawn.series[0].x == std::vector{0.02, -0.02, 0.02});
  CHECK(drawn.y.label == "moment");
  CHECK(drawn.y.unit == "N m");
  CHECK_FALSE(drawn.series[0].filled);  // a loop has no area below it
}

TEST_CASE("figures: a line that stands alone is named by its values, and filled to zero where it comes near it") {
  const Table table =
      table_of_rows({"tension_N", "x_m", "loss_J_per_m", "height_m"}, {{5e4, 0, 0.1, 20}, {5e4, 1, 0.3, 21}});
  auto f = figure("x_m", {"loss_J_per_m"});
  f.series = {"tension_N"};
  Plot drawn = plot(f, table);
  CHECK(names_of(drawn) == Names{"50 kN"});
  CHECK(drawn.series[0].filled);
  CHECK(drawn.y.from_zero);
  CHECK(drawn.x.tight);
  drawn = plot(figure("x_m", {"height_m"}), table);
  CHECK_FALSE(drawn.series[0].filled);
  CHECK_FALSE(drawn.y.from_zero);
}

TEST_CASE("figures: parts of a ledger have colours by meaning and zero is drawn for friction and the integrator only") {
  const Names columns = {"external_work_J", "friction_dissipation_J", "viscous_dissipation_J", "air_drag_J",
                         "numerical_dissipation_J"};
  const Plot drawn = plot(figure("cycle", columns), ledger());
  CHECK(names_of(drawn) == Names{"external work", "friction", "air drag", "numerical"});
  CHECK(drawn.y.label == "energy");
  CHECK(drawn.y.unit == "J");
  CHECK(drawn.series[0].colour == Colour::ink);
  CHECK(drawn.series[1].colour == Colour::orange);
  CHECK(drawn.series[1].filled);
  CHECK(drawn.series[2].colour == Colour::blue);
  CHECK(drawn.series[3].colour == Colour::red);
  CHECK(drawn.series[3].dashed);
  CHECK(drawn.series[0].markers);  // three points
}

TEST_CASE("figures: the words that all lines share stand at the axis") {
  const Table table = table_of_rows({"t_s", "probe_1_y_m", "probe_2_y_m", "share"}, {{0, 1, 2, 3}, {1, -1, 1, 2}});
  Plot drawn = plot(figure("t_s", {"probe_1_y_m", "probe_2_y_m"}), table);
  CHECK(drawn.x.label == "time");
  CHECK(drawn.y.label == "y");
  CHECK(names_of(drawn) == Names{"probe 1", "probe 2"});
  CHECK(drawn.series[1].custom_colour == "#e07e2b");  // numbered lines follow the ramp
  drawn = plot(figure("t_s", {"probe_1_y_m", "share"}), table);
  CHECK(drawn.y.label == "");
  CHECK(names_of(drawn) == Names{"probe 1 y (m)", "share"});
}

TEST_CASE("figures: a log scale drops points that are not positive") {
  const Table table = table_of_rows({"frequency_Hz", "power_W_per_m"}, {{0, 1}, {10, 0}, {10, 1e-3}, {20, 1e-2}});
  auto f = figure("frequency_Hz", {"power_W_per_m"});
  f.x_scale = f.y_scale = "log";
  const Plot drawn = plot(f, table);
  CHECK(drawn.x.log);
  CHECK(count_of(svg(drawn), "<circle") == 2);
  CHECK_FALSE(drawn.series[0].filled);
  const Table nothing = table_of_rows({"frequency_Hz", "power_W_per_m"}, {{0, 1}, {10, 0}, {20, -1}});
  CHECK_FALSE(plot_of(f, nothing).has_value());
}

TEST_CASE("figures: only the asked range of x is drawn, one point with a marker, none not at all") {
  const Table table = table_of_rows({"x_m", "y_m"}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  auto f = figure("x_m", {"y_m"});
  f.x_range = {{1, 2}};
  CHECK(plot(f, table).series[0].x == std::vector{1.0, 2.0});
  f.x_range = {{1, 1.5}};
  CHECK(plot(f, table).series[0].x == std::vector{1.0});
  CHECK(plot(f, table).series[0].markers);
  f.x_range = {{1.2, 1.5}};
  CHECK_FALSE(plot_of(f, table).has_value());
  CHECK_FALSE(plot_of(figure("x_m", {"y_m"}), Table({"x_m", "y_m"})).has_value());
}

TEST_CASE("figures: a band lies between its columns") {
  const Table table = table_of_rows({"x_m", "low_m", "high_m"}, {{0, -1, 1}, {1, -3, 2}});
  auto f = figure("x_m", {"low_m", "high_m"});
  f.kind = "band";
  const Plot drawn = plot(f, table);
  REQUIRE(drawn.series.size() == 1);
  CHECK(drawn.series[0].low == std::vector{-1.0, -3.0});
  CHECK(drawn.series[0].y == std::vector{1.0, 2.0});
  CHECK(drawn.series[0].name == "");
}

TEST_CASE("figures: a map has a cell per row and a key to its colours") {
  Table table({"x_m", "t_s", "force_N"});
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 4; ++k) table.append(std::vector{0.1 * i, 1.0 * k, 1000.0 * i * k});
  }
  auto f = figure("x_m", {"t_s", "force_N"});
  f.kind = "map";
  const std::string text = svg(plot(f, table));
  CHECK(count_of(text, "H") >= 2 * 20);
  CHECK(contains(text, ">force (kN): 0</text>"));
  CHECK(contains(text, ">12.0</text>"));
  CHECK_FALSE(contains(text, "nan"));
}

TEST_CASE("figures: a map of more cells than can be told apart draws some of them") {
  Table table({"x_m", "t_s", "force_N"});
  for (int i = 0; i < 1000; ++i) {
    for (int k = 0; k < 3; ++k) table.append(std::vector{0.1 * i, 1.0 * k, 1.0 * i});
  }
  auto f = figure("x_m", {"t_s", "force_N"});
  f.kind = "map";
  CHECK(count_of(svg(plot(f, table)), "H") < 2 * 3 * 200);
}

TEST_CASE("figures: of many lines some are named") {
  Table table({"mode", "x_m", "y"});
  for (int mode = 1; mode <= 20; ++mode) {
    for (int i = 0; i < 3; ++i) table.append(std::vector<double>{1.0 * mode, 1.0 * i, 1.0 * mode * i});
  }
  auto f = figure("x_m", {"y"});
  f.series = {"mode"};
  const Plot drawn = plot(f, table);
  CHECK(drawn.series.size() == 20);
  int named = 0;
  for (const auto& line : drawn.series) named += !line.name.empty();
  CHECK(named == 8);
  CHECK(drawn.series.front().name == "mode 1");
  CHECK(drawn.series.back().name == "mode 20");
}

TEST_CASE("the wires of a cross-section keep their proportions, and those that never slip are empty") {
  const Table table = table_of_rows({"across_m", "up_m", "radius_m", "slipping_share"},
                                    {{0, 0, 1e-3, 0}, {2e-3, 0, 1e-3, 1}, {-2e-3, 0, 1e-3, 0.25}, {0, 3e-3, 2e-3, 0}});
  auto f = figure("across_m", {"up_m", "radius_m", "slipping_share"});
  f.kind = "wires";
  const std::string text = svg(plot(f, table));
  CHECK(find_markup_fault(text) == "");
  CHECK(count_of(text, "<circle") == 4);
  CHECK(count_of(text, "fill=\"none\" cx") == 2);
  // The reach of 5 mm upward is half of the height: 2 mm is twice the radius of 1 mm.
  const auto number_after = [&](std::string_view key, std::size_t nth) {
    std::size_t at = 0;
    for (std::size_t i = 0; i <= nth; ++i) at = text.find(key, at) + key.size();
    return std::stod(text.substr(at));
  };
  const double radius = number_after(" r=\"", 0);
  CHECK(std::abs(number_after(" r=\"", 3) - 2 * radius) < 0.02);
  CHECK(std::abs(number_after(" cx=\"", 1) - number_after(" cx=\"", 0) - 2 * radius) < 0.03);
  CHECK(std::abs(number_after(" cy=\"", 0) - number_after(" cy=\"", 3) - 3 * radius) < 0.03);

  f.y.pop_back();
  CHECK(contains(message_of<InputError>([&] { (void)plot_of(f, table); }), "shows wires by 2 columns"));
}

TEST_CASE("of many lines as many are drawn as can be told apart, and the rest is said") {
  Table table({"loop", "curvature_per_m", "moment_N_m"});
  for (int loop = 0; loop < 100; ++loop) {
    for (const double x : {0.0, 1.0}) table.append(std::vector{double(loop), x, loop * x});
  }
  auto f = figure("curvature_per_m", {"moment_N_m"});
  f.series = {"loop"};
  const Plot drawn = plot(f, table);
  CHECK(drawn.series.size() == 24);
  CHECK(drawn.note == "24 of 100 lines are drawn; all are in t.csv.");
  CHECK(drawn.series.front().y.back() == 0);
  CHECK(drawn.series.back().y.back() == 99);
  CHECK(drawn.series[1].label.find("loop") != std::string::npos);
  f.kind = "motion";
  CHECK(plot(f, table).series.size() == 100);
}
