#include "strandyn/model/model.hpp"

#include <doctest/doctest.h>

#include "support/check_close.hpp"

using namespace strandyn::model;
using strandyn::test::check_close;

TEST_CASE("model: a straight span is stretched by its strain, every element alike") {
  Model model;
  lay_out(model, {.positions = {0, 1, 3, 7}, .strain = 0.01});
  REQUIRE(model.nodes.size() == 4);
  REQUIRE(model.elements.size() == 3);
  CHECK(model.unknowns() == 12);
  for (const auto& element : model.elements) {
    check_close(element.span.norm() / element.length, 1.01, {.relative = 1e-15});
    CHECK(element.triad == Eigen::Matrix3d::Identity());
    CHECK(element.span.y() == 0.0);
    CHECK(element.span.z() == 0.0);
  }
  check_close(model.unstressed_length(), 7 / 1.01, {.relative = 1e-15});
}

TEST_CASE("model: laying out again replaces the chain") {
  Model model;
  lay_out(model, {.positions = {0, 1, 3}, .strain = 0});
  lay_out(model, {.positions = {0, 2}, .strain = 0});
  CHECK(model.nodes.size() == 2);
  CHECK(model.elements.size() == 1);
}

TEST_CASE("model: messages name an unknown by its node and kind") {
  const Model model;  // planar unless it is told
  CHECK(model.unknown_name(0) == "node 0 displacement x");
  CHECK(model.unknown_name(3 * 41 + 1) == "node 41 displacement y");
  CHECK(model.unknown_name(3 * 41 + 2) == "node 41 rotation z");
}

TEST_CASE("model: the nearest node is found along the span") {
  Model model;
  lay_out(model, {.positions = {0, 1, 3, 7}, .strain = 0});
  CHECK(nearest_node(model, -1) == 0);
  CHECK(nearest_node(model, 1.9) == 1);
  CHECK(nearest_node(model, 2.1) == 2);
  CHECK(nearest_node(model, 100) == 3);
}
