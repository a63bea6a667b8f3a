// What every method of a self-damping study must do, whatever its physics: held by all words of the case file.
#include <doctest/doctest.h>

#include <algorithm>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/self_damping/method.hpp"

using namespace strandyn;
using casefile::DampingMethod;
using self_damping::Point;
using self_damping::PointRow;

namespace {

/// Six metres of Curlew in the fourth mode, short, so that a method in time is quick.
casefile::Scene scene_for(DampingMethod method, const std::string& more = "") {
  return casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"return-map\"\n"
      "[span]\nlength_m = 6\nelements = 32\nmass = \"consistent\"\n"
      "[analysis]\ntype = \"self-damping\"\nmode_shape = \"clamped\"\nmodes = 4\ntensions_rts = 0.2\n"
      "antinode_amplitude_mm = [2, 3]\nmethod = \"" +
          std::string(name_of(method)) + "\"\n" + more,
      "battery.toml");
}

/// The points of a study as a study computes them: all methods begun once with all of their points.
std::vector<PointRow> rows_of(const casefile::Scene& scene, bool backwards = false) {
  std::vector<Point> points = self_damping::points_of(scene);
  const auto method = self_damping::make_method(points.front().method, scene);
  method->begin(points);
  if (backwards) std::reverse(points.begin(), points.end());
  std::vector<PointRow> rows;
  for (const Point& point : points) rows.push_back(*self_damping::compute_row(scene, *method, point, {}));
  if (backwards) std::reverse(rows.begin(), rows.end());
  return rows;
}

std::string text_of(const PointRow& row) {
  return results::to_text(results::to_value(row), -1);
}

template <class Test>
void for_each_method(const Test& test) {
  for (const auto& word : choices<DampingMethod>) {
    CAPTURE(word.name);
    test(word.value);
  }
}

}  // namespace

TEST_CASE("method battery: loss in gross slip is positive and grows faster than the square of the amplitude") {
  for_each_method([](DampingMethod method) {
    const std::vector<PointRow> rows = rows_of(scene_for(method));
    REQUIRE(rows.size() == 2);
    for (const PointRow& row : rows) {
      CAPTURE(row.failed.value_or(""));
      REQUIRE(row.has_numbers());
      CHECK(row.method == name_of(method));
      CHECK(*row.self_damping > 0);
    }
    CHECK(*rows[1].self_damping > 1.5 * 1.5 * *rows[0].self_damping);
  });
}

TEST_CASE("method battery: a point does not depend on the order of the points, and its row survives the log") {
  for_each_method([](DampingMethod method) {
    const casefile::Scene scene = scene_for(method);
    const std::vector<PointRow> forwards = rows_of(scene);
    const std::vector<PointRow> backwards = rows_of(scene, true);
    for (std::size_t i = 0; i < forwards.size(); ++i) {
      CHECK(text_of(forwards[i]) == text_of(backwards[i]));
      PointRow read;
      CHECK(results::RecordReader::fill(read, *results::from_line(text_of(forwards[i]))) == 0);
      CHECK(text_of(read) == text_of(forwards[i]));
    }
  });
}

TEST_CASE("method battery: all methods mean the same quantity") {
  // Gross slip of rigid contacts in the free span of four loops, by methods that share no formula; one is a closed
  // form.
  const double reference = *rows_of(scene_for(DampingMethod::periodic))[1].free_span;
  for_each_method([&](DampingMethod method) {
    const double ratio = *rows_of(scene_for(method))[1].free_span / reference;
    CAPTURE(ratio);
    const bool own_law = method == DampingMethod::foti_2018;
    CHECK(ratio > (own_law ? 0.2 : 0.95));
    CHECK(ratio < (own_law ? 5.0 : 1.05));
  });
}

TEST_CASE("method battery: what is expected to be asked of sections is a range that ends above its beginning") {
  for_each_method([](DampingMethod method) {
    const casefile::Scene scene = scene_for(method);
    const std::vector<Point> points = self_damping::points_of(scene);
    const self_damping::Expected all = self_damping::make_method(method, scene)->expected(points);
    const self_damping::Expected one = self_damping::make_method(method, scene)->expected({points.front()});
    CHECK(all.least <= all.most);
    CHECK(one.most <= all.most);
  });
}

TEST_CASE("method battery: a point that is told to stop is no result") {
  for_each_method([](DampingMethod method) {
    const casefile::Scene scene = scene_for(method);
    const std::vector<Point> points = self_damping::points_of(scene);
    const auto made = self_damping::make_method(method, scene);
    made->begin(points);
    const auto row = self_damping::compute_row(scene, *made, points.front(), {.stop = [] { return true; }});
    const bool at_once = method == DampingMethod::quadrature || method == DampingMethod::foti_2018;
    CHECK(row.has_value() == at_once);  // these are done before they could be asked
  });
}
