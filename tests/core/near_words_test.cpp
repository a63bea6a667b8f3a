#include "strandyn/core/near_words.hpp"

#include <doctest/doctest.h>

using namespace strandyn;

TEST_CASE("the distance of two words counts slips of the pen") {
  CHECK(edit_distance("span", "span") == 0);
  CHECK(edit_distance("", "span") == 4);
  CHECK(edit_distance("lenght_m", "length_m") == 1);  // two letters swapped
  CHECK(edit_distance("tension_N", "tension_kN") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("abc", "ca") == 3);  // swapped letters are not edited again
}

TEST_CASE("only a near word is offered") {
  const std::vector<std::string> keys{"length_m", "tension_kN", "left"};
  CHECK(near_word("lenght_m", keys) == "length_m");
  CHECK(near_word("colour", keys) == std::nullopt);
  CHECK(near_word("x", {}) == std::nullopt);
  CHECK(nearest_first("lift", keys).front() == "left");
}
