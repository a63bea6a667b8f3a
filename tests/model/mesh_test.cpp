#include "strandyn/model/mesh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "support/check_close.hpp"

using namespace strandyn::model;
using strandyn::test::check_close;

namespace {

/// The laboratory span: 30 m, 80 elements, both ends clamped.
MeshOptions laboratory_span() {
  return {.length = 30, .elements = 80, .end_size = 0.02, .grade_left = true, .grade_right = true, .stations = {}};
}

std::vector<double> sizes(const std::vector<double>& nodes) {
  std::vector<double> out;
  for (std::size_t i = 1; i < nodes.size(); ++i) out.push_back(nodes[i] - nodes[i - 1]);
  return out;
}

void check_covers(const std::vector<double>& nodes, const MeshOptions& options) {
  REQUIRE(nodes.size() == options.elements + 1);
  CHECK(nodes.front() == 0.0);
  CHECK(nodes.back() == options.length);
  CHECK(std::is_sorted(nodes.begin(), nodes.end()));
  for (const double size : sizes(nodes)) CHECK(size > 0);
}

}  // namespace

TEST_CASE("mesh: a uniform span has equal elements") {
  const MeshOptions options{.length = 30, .elements = 7, .stations = {}};
  const auto nodes = span_mesh(options);
  check_covers(nodes, options);
  for (const double size : sizes(nodes)) check_close(size, 30.0 / 7, {.relative = 1e-14});
}

TEST_CASE("mesh: one element joins the ends, graded or not") {
  MeshOptions options = laboratory_span();
  options.elements = 1;
  CHECK(span_mesh(options) == std::vector<double>{0, 30});
  options.grade_left = options.grade_right = false;
  CHECK(span_mesh(options) == std::vector<double>{0, 30});
}

TEST_CASE("mesh: graded elements grow from the clamps to the middle and mirror each other") {
  const MeshOptions options = laboratory_span();
  const auto nodes = span_mesh(options);
  check_covers(nodes, options);
  const auto size = sizes(nodes);
  for (std::size_t i = 0; i + 1 < 40; ++i) CHECK(size[i] <= size[i + 1] * (1 + 1e-12));
  for (std::size_t i = 0; i < 80; ++i) check_close(size[i], size[79 - i], {.relative = 1e-10});
}

TEST_CASE("mesh: sizes begin as wanted and follow their distance from the clamp") {
  const MeshOptions options = laboratory_span();
  const auto nodes = span_mesh(options);
  // d(number)/ds = 1/(e + g s): node i lies at e (exp(g i) - 1)/g while the graded part lasts.
  for (std::size_t i = 1; i <= 5; ++i) {
    const double expected = 0.02 * std::expm1(0.25 * static_cast<double>(i)) / 0.25;
    check_close(nodes[i], expected, {.relative = 1e-12});
  }
  const auto size = sizes(nodes);
  CHECK(size[0] < 1.15 * 0.02);
  // Neighbours differ by less than exp(g).
  for (std::size_t i = 1; i < size.size(); ++i) CHECK(std::abs(std::log(size[i] / size[i - 1])) <= 0.25 + 1e-9);
}

TEST_CASE("mesh: one clamped end is graded alone") {
  MeshOptions options = laboratory_span();
  options.grade_right = false;
  const auto nodes = span_mesh(options);
  check_covers(nodes, options);
  const auto size = sizes(nodes);
  check_close(size.front(), 0.02 * std::expm1(0.25) / 0.25, {.relative = 1e-12});
  check_close(size.back(), *std::max_element(size.begin(), size.end()), {.relative = 1e-10});
}

TEST_CASE("mesh: too few elements for the wanted end size make all of them grow alike") {
  for (const std::size_t elements : {2, 3, 4, 6, 10}) {
    MeshOptions options = laboratory_span();
    options.end_size = 1e-3;
    options.elements = elements;
    const auto nodes = span_mesh(options);
    check_covers(nodes, options);
    const auto size = sizes(nodes);
    CHECK(size.front() > options.end_size);
    check_close(size.front(), size.back(), {.relative = 1e-9});
    if (elements != 10) continue;
    // End size and growth times the same factor: nodes divide log(1 + g s/e) evenly, and no other trace is left of it.
    const double ratio = 0.25 / options.end_size;
    for (std::size_t i = 1; i <= 5; ++i) {
      const double expected = (std::pow(1 + 15 * ratio, static_cast<double>(i) / 5) - 1) / ratio;
      check_close(nodes[i], expected, {.relative = 1e-9});
    }
  }
}

TEST_CASE("mesh: a wanted end size above the uniform one leaves the mesh uniform") {
  MeshOptions options = laboratory_span();
  options.end_size = 1;
  for (const double size : sizes(span_mesh(options))) check_close(size, 30.0 / 80, {.relative = 1e-12});
}

TEST_CASE("mesh: stations are nodes, to the last digit, and their neighbours make room") {
  MeshOptions options = laboratory_span();
  options.stations = {0.7, 12.34, 12.5, 29.9, 12.34};
  const auto nodes = span_mesh(options);
  check_covers(nodes, options);
  for (const double station : options.stations) CHECK(std::count(nodes.begin(), nodes.end(), station) == 1);
  const auto size = sizes(nodes);
  for (std::size_t i = 1; i < size.size(); ++i) {
    // Two stations 0.16 m apart among elements of 0.5 m are the worst place.
    CHECK(std::max(size[i], size[i - 1]) <= 5 * std::min(size[i], size[i - 1]));
  }
}

TEST_CASE("mesh: places that differ by rounding are one place and places a millimetre apart are two") {
  MeshOptions options = laboratory_span();
  options.stations = {3.333333, 3.333334, 3.3333331, 3e-4, 29.9998};
  const std::vector<double> nodes = span_mesh(options);
  CHECK(std::count(nodes.begin(), nodes.end(), 3.333333) == 1);
  for (std::size_t i = 1; i < nodes.size(); ++i) CHECK(nodes[i] - nodes[i - 1] > 1e-2);
  options.stations = {3.333, 3.334};
  const std::vector<double> two = span_mesh(options);
  for (const double station : options.stations) CHECK(std::count(two.begin(), two.end(), station) == 1);
}

TEST_CASE("mesh: stations at or beyond the ends change nothing") {
  MeshOptions options = laboratory_span();
  const auto without = span_mesh(options);
  options.stations = {0, 30, -1, 31};
  CHECK(span_mesh(options) == without);
}

TEST_CASE("mesh: the number of elements for a size in the middle gives that size") {
  MeshOptions options = laboratory_span();
  for (const double middle : {0.1, 0.25, 1.0}) {
    options.elements = elements_for(options, middle);
    const auto size = sizes(span_mesh(options));
    const double longest = *std::max_element(size.begin(), size.end());
    // Rounded up to whole elements: not longer than wanted, and one element fewer would be.
    CHECK(longest <= middle * (1 + 1e-9));
    --options.elements;
    const auto coarser = sizes(span_mesh(options));
    CHECK(*std::max_element(coarser.begin(), coarser.end()) > middle * (1 - 1e-3));
  }
  CHECK(elements_for({.length = 1, .stations = {}}, 5) == 1);
}

TEST_CASE("mesh: 20 000 elements are laid out in a moment") {
  MeshOptions options = laboratory_span();
  options.elements = 20000;
  options.end_size = 1e-4;
  options.stations = {0.7, 15.1};
  const auto start = std::chrono::steady_clock::now();
  const auto nodes = span_mesh(options);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  check_covers(nodes, options);
  CHECK(time.count() < 5);  // measured 0.1 s; only a cost that grows with the square would miss this
}
