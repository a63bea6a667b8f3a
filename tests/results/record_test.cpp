// Records read from what a file holds: numbers that a member cannot hold are missing, and change nothing.
#include "strandyn/results/record.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include "strandyn/results/json.hpp"

using namespace strandyn::results;

namespace {

struct Counts {
  std::size_t points = 7;
  int mode = 7;
  double power = 7;
};
template <class V>
void members(V& v, Counts& c) {
  v.value("points", c.points, {.what = "a count"});
  v.value("mode", c.mode, {.what = "a whole number"});
  v.value("power", c.power, {.what = "any number"});
}

int missing_in(const std::string& text, Counts& counts) {
  return RecordReader::fill(counts, from_text(text, "test"));
}

}  // namespace

TEST_CASE("record: whole members take whole numbers within their range and nothing else") {
  for (const char* points : {"1e30", "-1e30", "-1", "2.5", "1.8446744073709552e19", "true", "\"3\"", "null"}) {
    CAPTURE(points);
    Counts counts;
    CHECK(missing_in(std::string("{\"points\": ") + points + ", \"mode\": 3, \"power\": 2}", counts) == 1);
    CHECK(counts.points == 7);
    CHECK(counts.mode == 3);
  }
  for (const char* mode : {"2147483648", "-2147483649", "2147483648.0", "1e10", "-0.5"}) {
    CAPTURE(mode);
    Counts counts;
    CHECK(missing_in(std::string("{\"points\": 1, \"mode\": ") + mode + ", \"power\": 2}", counts) == 1);
    CHECK(counts.mode == 7);
  }
}

TEST_CASE("record: the ends of a range are in it and whole numbers may be written as real ones") {
  Counts counts;
  CHECK(missing_in("{\"points\": 18446744073709551615, \"mode\": -2147483648.0, \"power\": 3}", counts) == 0);
  CHECK(counts.points == UINT64_MAX);
  CHECK(counts.mode == INT32_MIN);
  CHECK(counts.power == 3);
  CHECK(missing_in("{\"points\": 3.0, \"mode\": 2147483647, \"power\": -1}", counts) == 0);
  CHECK(counts.points == 3);
  CHECK(counts.mode == INT32_MAX);
}
