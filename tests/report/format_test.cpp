#include "strandyn/report/format.hpp"

#include <doctest/doctest.h>

#include <string>

using strandyn::report::duration;
using strandyn::report::prefix_for;
using strandyn::report::quantity;
using strandyn::report::significant;
using strandyn::report::typeset;

TEST_CASE("format: significant digits are kept, zeros included, and rounding carries over") {
  CHECK(significant(0) == "0");
  CHECK(significant(1.25) == "1.250");
  CHECK(significant(-0.00123456) == "-0.001235");
  CHECK(significant(9.9996) == "10.00");
  CHECK(significant(0.99996) == "1.000");
  CHECK(significant(123456.7) == "123457");
  CHECK(significant(999999.7) == "1.000e+06");
  CHECK(significant(1.234e-6) == "1.234e-06");
  CHECK(significant(0.0001) == "0.0001000");
  CHECK(significant(12.0, 1) == "12");
}

TEST_CASE("format: a page has true minus signs and powers of ten") {
  CHECK(typeset(-0.5) == "−0.5000");
  CHECK(typeset(1.234e-6) == "1.234×10⁻⁶");
  CHECK(typeset(-2.5e12, 2) == "−2.5×10¹²");
  CHECK(typeset(0) == "0");
}

TEST_CASE("format: a prefix brings a value to between one and a thousand") {
  CHECK(prefix_for(0).symbol == "");
  CHECK(prefix_for(1).symbol == "");
  CHECK(prefix_for(0.9999).symbol == "m");
  CHECK(prefix_for(0.99996).symbol == "");  // shown as 1.000
  CHECK(prefix_for(-4.7e7).symbol == "M");
  CHECK(prefix_for(1e-15).symbol == "n");
}

TEST_CASE("format: quantities take a prefix where their unit allows one") {
  const auto shown = [](double value, std::string_view unit) {
    const auto q = quantity(value, unit);
    return q.number + " " + q.unit;
  };
  CHECK(shown(4.71459e7, "N") == "47.15 MN");
  CHECK(shown(1.2e-3, "W/m") == "1.200 mW/m");
  CHECK(shown(2387.42, "N m²") == "2387 N m²");
  CHECK(shown(0.032618, "1/m") == "0.03262 1/m");
}

TEST_CASE("format: durations read like a clock") {
  CHECK(duration(0.42) == "0 s");
  CHECK(duration(0.42, true) == "0.4 s");
  CHECK(duration(9.97, true) == "10 s");
  CHECK(duration(59.6) == "1 min 00 s");
  CHECK(duration(75) == "1 min 15 s");
  CHECK(duration(3599.7) == "1 h 00 min");
  CHECK(duration(4020) == "1 h 07 min");
}
