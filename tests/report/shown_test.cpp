#include "strandyn/report/shown.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "report/markup.hpp"
#include "results/scratch_folder.hpp"
#include "results/small_run.hpp"
#include "strandyn/core/error.hpp"

using strandyn::InputError;
using strandyn::report::html_of;
using strandyn::report::quantity_of;
using strandyn::report::text_of;
using strandyn::results::Highlight;
using strandyn::results::ShownTable;
using strandyn::test::contains;
using strandyn::test::message_of;
using strandyn::test::table_of_rows;

namespace {

const ShownTable shown = {.title = "Energy of each cycle",
                          .table = "cycles.csv",
                          .columns = {"cycle", "t_s", "antinode_amplitude_m", "friction_dissipation_J",
                                      "numerical_dissipation_J", "numerical_share"}};

}  // namespace

TEST_CASE("shown: a number has the unit of its path, a share is in per cent, a count keeps its digits") {
  const auto words = [](const std::string& path, double value) {
    const auto q = quantity_of(Highlight{.name = "n", .path = path, .value = value});
    return q.number + "|" + q.unit;
  };
  CHECK(words("steady.antinode_amplitude_m", 8.4e-3) == "8.400|mm");
  CHECK(words("chi_0_per_m", 0.032618) == "0.03262|1/m");
  CHECK(words("steady.numerical_share", 0.0125) == "1.25|%");
  CHECK(words("frequencies_Hz[0]", 1.85) == "1.850|Hz");
  CHECK(words("balance[2].amplitude_m", 2) == "2.000|m");
  CHECK(words("steady.cycles", 12) == "12|");
  CHECK(words("fit.k", 1.5) == "1.500|");
}

TEST_CASE("shown: numbers stand below each other in the terminal") {
  CHECK(text_of(std::vector<Highlight>{{.name = "antinode amplitude", .path = "a_m", .value = 1.234e-5},
                                       {.name = "χ₀", .path = "chi_0_per_m", .value = 0.125},
                                       {.name = "cycles", .path = "cycles", .value = 12}}) ==
        "antinode amplitude   12.34 um\n"
        "χ₀                  0.1250 1/m\n"
        "cycles                  12\n");
  CHECK(text_of(std::vector<Highlight>{}).empty());
}

TEST_CASE("shown: a table is printed with energies of one prefix, counts and shares") {
  const auto table = table_of_rows(
      {"cycle", "t_s", "antinode_amplitude_m", "friction_dissipation_J", "numerical_dissipation_J", "numerical_share"},
      {{1, 0.5, 0.002, 1e-5, 1e-8, 0.001}, {2, 1, 0.003, 2e-5, -3e-8, 0.0015}});
  CHECK(text_of(shown, table) ==
        "                antinode                       numerical\n"
        "cycle    time  amplitude  friction  numerical      share\n"
        "            s         mm        uJ         uJ          %\n"
        "-----  ------  ---------  --------  ---------  ---------\n"
        "    1  0.5000      2.000     10.00    0.01000      0.100\n"
        "    2   1.000      3.000     20.00   -0.03000      0.150\n");
  CHECK(html_of(shown, table).columns[3].unit == "µJ");
  CHECK(html_of(shown, table).rows[1][4] == "−0.03000");
  CHECK(text_of(shown, strandyn::results::Table(table.names())).empty());
}

TEST_CASE("shown: of a long table at most twenty rows are printed, the first and the last among them") {
  strandyn::results::Table table({"cycle"});
  for (int i = 1; i <= 57; ++i) table.append(std::vector{1.0 * i});
  const auto text = text_of({.title = "t", .table = "t.csv", .columns = {"cycle"}}, table);
  CHECK(std::count(text.begin(), text.end(), '\n') == 2 + 20 + 1);
  CHECK(contains(text, "(20 of 57 rows; all are in t.csv)"));
  CHECK(contains(text, "\n    1\n"));
  CHECK(contains(text, "\n   57\n"));
}

TEST_CASE("shown: a column that is not there is refused by name") {
  const auto table = table_of_rows({"cycle", "t_s"}, {{1, 0.5}});
  CHECK(message_of<InputError>([&] { text_of(shown, table); }) ==
        "the shown table 'Energy of each cycle' of summary.json asks for the column 'antinode_amplitude_m' of "
        "cycles.csv, which has cycle, t_s");
}
