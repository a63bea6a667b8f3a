#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "study/scenes.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using test::check_close;
using test::span_scene;

namespace {

const std::string shaker =
    "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.5\namplitude_N = 60\nfrequency = \"mode 4\"\n"
    "[analysis]\ntype = \"forced\"\n";

const results::Table& table(const test::Run& result, const std::string& file) {
  const auto found = std::ranges::find(result.tables, file, &results::NamedTable::file);
  REQUIRE(found != result.tables.end());
  return found->table;
}

}  // namespace

TEST_CASE("the cycle gone through once more loses what the ledger has of a steady vibration") {
  const auto ran = test::run(span_scene(shaker + "until = \"steady\"\n"));
  CHECK(ran.summary["steady"]["is_steady"] == true);
  const double friction = ran.summary["cycles"].back()["friction_dissipation_J"];
  CHECK(friction > 1e-3);
  // The next cycle differs from the last by what steadiness allows, 1 % of the loss over twenty cycles.
  check_close(ran.summary["slip_cycle"]["friction_J"], friction, {.relative = 0.01});
}

TEST_CASE("the slip map is that of the clamps, and its wires stand in the strand") {
  const auto ran = test::run(span_scene(shaker, {"analysis.cycles=12"}));
  const auto& slip = ran.summary["slip_cycle"];
  const double at = slip["at_m"], most = slip["largest_share"];
  CHECK(std::min(at, 10 - at) < 0.1);
  CHECK(most > 0.1);
  CHECK(most <= 1);

  // Twice a cycle the section beside the clamp turns round, and then no wire slips: the share of its map falls to
  // nothing between two stretches of slip.
  const results::Table& map = table(ran, "slip_map.csv");
  std::map<double, double> of_phase;
  for (std::size_t row = 0; row < map.rows(); ++row) {
    const double share = map.column("slipping_share")[row];
    CHECK(share >= 0);
    CHECK(share <= 1);
    if (map.column("x_m")[row] == at) of_phase[map.column("phase_deg")[row]] = share;
  }
  REQUIRE(of_phase.size() == 36);
  int beginnings = 0;
  double before = of_phase.rbegin()->second;
  for (const auto& [phase, share] : of_phase) {
    beginnings += share > 0 && before == 0;
    before = share;
  }
  CHECK(beginnings == 2);

  // 60 wires and a core; the outermost ring touches the outer diameter, and wires of a layer do not overlap.
  const results::Table& section = table(ran, "cross_section.csv");
  REQUIRE(section.rows() == 61);
  double outer = 0;
  for (std::size_t i = 0; i < section.rows(); ++i) {
    const auto of = [&](const char* name, std::size_t row) { return section.column(name)[row]; };
    outer = std::max(outer, std::hypot(of("across_m", i), of("up_m", i)) + of("radius_m", i));
    for (std::size_t k = 0; k < i; ++k) {
      const double apart = std::hypot(of("across_m", i) - of("across_m", k), of("up_m", i) - of("up_m", k));
      CHECK(apart > 0.98 * (of("radius_m", i) + of("radius_m", k)));
    }
  }
  check_close(2 * outer, 31.68e-3, {.absolute = 1e-9});

  // Every wire of a layer goes around the lay in one lay length: beside the clamp each slips somewhere, if one does.
  const results::Table& wires = table(ran, "wire_map.csv");
  std::map<double, std::map<double, double>> of_layer;
  for (std::size_t row = 0; row < wires.rows(); ++row) {
    double& largest = of_layer[wires.column("layer")[row]][wires.column("wire")[row]];
    largest = std::max(largest, wires.column("slipping_share")[row]);
  }
  REQUIRE(of_layer.size() == 4);
  CHECK(of_layer[4].size() == 24);
  for (const auto& [wire, share] : of_layer[4]) CHECK(share > 0);
}

TEST_CASE("a law without wires has no slip map, and a span that sticks has one of nothing") {
  const auto masing = test::run(span_scene(shaker, {"analysis.cycles=2", "section.law=masing"}));
  CHECK(!masing.summary.contains("slip_cycle"));
  const auto sticks = test::run(span_scene(shaker, {"analysis.cycles=2", "load[0].amplitude_N=0.001"}));
  CHECK(sticks.summary["slip_cycle"]["largest_share"] == 0.0);
  CHECK(sticks.summary["slip_cycle"]["friction_J"] == 0.0);
  CHECK(std::ranges::find(sticks.tables, "slip_map.csv", &results::NamedTable::file) == sticks.tables.end());
}
