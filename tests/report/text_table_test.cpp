#include "strandyn/report/text_table.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using strandyn::report::Align;
using strandyn::report::shown_width;
using strandyn::report::TextTable;

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

TEST_CASE("text table: a header of two lines stands on the line of its unit") {
  TextTable table({{.header = "friction\nloss", .unit = "J"}, {.header = "n"}});
  table.add_row({1.5, 2});
  CHECK(table.str() ==
        "friction\n"
        "    loss  n\n"
        "       J\n"
        "--------  -\n"
        "   1.500  2\n");
}
