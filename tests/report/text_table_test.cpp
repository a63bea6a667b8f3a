#include "strandyn/report/text_table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "strandyn/report/cycle_table.hpp"

using nlohmann::ordered_json;
using strandyn::report::Align;
using strandyn::report::cycle_rows;
using strandyn::report::cycle_table;
using strandyn::report::evenly_spaced;
using strandyn::report::shown_width;
using strandyn::report::TextTable;

namespace {

ordered_json cycle(double friction, double numerical) {
  return {{"t_s", 0.5},
          {"antinode_amplitude_m", 0.002},
          {"external_work_J", 1.0},
          {"friction_dissipation_J", friction},
          {"viscous_dissipation_J", 0.1},
          {"numerical_dissipation_J", numerical},
          {"elements_slipping", 12}};
}

}  // namespace

TEST_CASE("text table: headers, units, words to the left, numbers to the right") {
  TextTable table(
      {{.header = "what", .align = Align::left}, {.header = "got", .unit = "N m²", .digits = 3}, {.header = "n"}});
  table.add_row({"EI_max, Curlew", 2387.42, 7});
  table.add_row({"χ", std::optional<double>{}, 1234567});
  table.add_row({"small", -1.5e-9, "none"});
  CHECK(table.str() ==
        "what                  got        n\n"
        "                     N m²\n"
        "--------------  ---------  -------\n"
        "EI_max, Curlew       2387        7\n"
        "χ                       -  1234567\n"
        "small           -1.50e-09     none\n");
}

TEST_CASE("text table: without units there is no line for them") {
  TextTable table({{.header = "a"}, {.header = "b", .align = Align::left}});
  table.add_row({1, "x"});
  CHECK(table.str() == "a  b\n-  -\n1  x\n");
}

TEST_CASE("text table: a row of the wrong width is refused") {
  TextTable table({{.header = "a"}});
  CHECK_THROWS_AS(table.add_row({1, 2}), std::invalid_argument);
}

TEST_CASE("text table: the width of a text counts characters, not bytes") {
  CHECK(shown_width("N m²") == 4);
  CHECK(shown_width("χ₀ ×10⁻³") == 8);
}

TEST_CASE("cycle table: the numerical part stands beside the friction part, energies share a prefix") {
  CHECK(cycle_table(ordered_json::array({cycle(0.7, 0.004), cycle(0.8, -0.009)})) ==
        "cycle    time  amplitude  ext. work  stored  viscous  friction  numerical  share  slipping\n"
        "            s         mm          J       J        J         J          J      %  elements\n"
        "-----  ------  ---------  ---------  ------  -------  --------  ---------  -----  --------\n"
        "    1  0.5000      2.000      1.000  0.1960   0.1000    0.7000   0.004000  0.500        12\n"
        "    2  0.5000      2.000      1.000  0.1090   0.1000    0.8000  -0.009000   1.00        12\n");
  auto small = cycle(1e-5, 1e-8);
  small["external_work_J"] = 2e-5;
  small["viscous_dissipation_J"] = 0;
  const auto text = cycle_table(ordered_json::array({small}));
  CHECK(text.find("uJ") != std::string::npos);
  CHECK(text.find("20.00   9.990        0     10.00    0.01000  0.100  ") != std::string::npos);
}

TEST_CASE("cycle table: the ledger of a row closes, and the share is of what is lost") {
  const auto row = cycle_rows(ordered_json::array({cycle(0.7, -0.004)})).at(0);
  CHECK(row.cycle == 1);
  CHECK(std::abs(*row.stored + *row.friction + *row.viscous + *row.numerical - *row.external) < 1e-15);
  CHECK(*row.numerical_share == 0.004 / (0.7 + 0.1));
}

TEST_CASE("cycle table: where nothing is lost there is no share, what is missing is a dash") {
  auto lossless = cycle(0, 0.001);
  lossless["viscous_dissipation_J"] = 0;
  lossless.erase("elements_slipping");
  lossless.erase("antinode_amplitude_m");
  const auto text = cycle_table(ordered_json::array({lossless}));
  CHECK(text.find("    1  0.5000          -      1.000  0.9990        0         0   0.001000      -         -\n") !=
        std::string::npos);
  CHECK(cycle_table(ordered_json::array()).empty());
  CHECK(cycle_table(ordered_json()).empty());
}

TEST_CASE("cycle table: of many cycles the first, the last and evenly spaced ones are shown") {
  CHECK(evenly_spaced(3, 20) == std::vector<std::size_t>{0, 1, 2});
  CHECK(evenly_spaced(100, 1) == std::vector<std::size_t>{99});
  CHECK(evenly_spaced(0, 20).empty());
  const auto chosen = evenly_spaced(1000, 20);
  REQUIRE(chosen.size() == 20);
  CHECK(chosen.front() == 0);
  CHECK(chosen.back() == 999);
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    CHECK(chosen[i] - chosen[i - 1] >= 52);  // 999/19 = 52.6
    CHECK(chosen[i] - chosen[i - 1] <= 53);
  }
  auto cycles = ordered_json::array();
  for (int i = 0; i < 57; ++i) cycles.push_back(cycle(0.7, 0.004));
  const auto text = cycle_table(cycles);
  CHECK(std::count(text.begin(), text.end(), '\n') == 3 + 20);
  CHECK(text.find("\n   57  ") != std::string::npos);
}
