#include "strandyn/observe/deflection_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::observe::DeflectionPoints;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::SpanOptions;

namespace {

/// All unknowns of a span whose nodes lie on y(x) with its slope.
template <class F, class G>
system::Vector on_curve(const model::Model& model, F&& y, G&& slope) {
  system::Vector u = test::zeros(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    u(static_cast<Eigen::Index>(3 * i + 1)) = y(model.nodes[i].x());
    u(static_cast<Eigen::Index>(3 * i + 2)) = slope(model.nodes[i].x());
  }
  return u;
}

}  // namespace

TEST_CASE("deflection points: a cubic is read exactly between the nodes") {
  const model::Model model = curlew_span(test::stick_law(), {.length = 4, .elements = 3, .graded = false});
  const DeflectionPoints points(model, 10);  // fewer than three loops: the whole span
  REQUIRE(points.size() == 24);
  const auto y = [](double x) { return 0.1 + 0.2 * x - 0.3 * x * x + 0.05 * x * x * x; };
  const auto u = on_curve(model, y, [](double x) { return 0.2 - 0.6 * x + 0.15 * x * x; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = 4.0 / 24 * (static_cast<double>(i) + 0.5);
    check_close(points.at(u.data(), i), y(x), {.absolute = 1e-14});
  }
}

TEST_CASE("deflection points: a crest between two nodes is found wherever it lies") {
  const SpanOptions span{.length = 30, .elements = 60, .graded = false};
  const model::Model model = curlew_span(test::stick_law(), span);
  const double k = std::numbers::pi / 2.5;  // five elements a loop
  const DeflectionPoints points(model, 2.5);
  for (const double shift : {0.0, 0.1, 0.25, 0.4}) {
    const auto u = on_curve(
        model, [&](double x) { return -2e-3 * std::sin(k * (x - shift)); },
        [&](double x) { return -2e-3 * k * std::cos(k * (x - shift)); });
    // pi^2/2 (l/16)^2/loop^2 of the place, and (k l)^4/384 of the Hermite curve, which lies below the crest.
    check_close(points.largest(u.data()), 2e-3, {.relative = 1.2e-3});
    CHECK(points.largest(u.data()) <= 2e-3);
  }
}

TEST_CASE("deflection points: the loops at the ends are left out where there are three or more") {
  const model::Model model = curlew_span(test::stick_law(), {.length = 6, .elements = 12, .graded = false});
  CHECK(DeflectionPoints(model, 2).size() == 4 * 8);
  CHECK(DeflectionPoints(model, 2.1).size() == 12 * 8);
  auto u = test::zeros(model);
  u(4) = 1;                                                                             // at 0.5 m
  u(19) = 1e-3;                                                                         // at 3 m
  check_close(DeflectionPoints(model, 2).largest(u.data()), 1e-3, {.relative = 0.02});  // a kink of nodes, not a crest
  CHECK(DeflectionPoints(model, 2.1).largest(u.data()) > 0.9);
}
