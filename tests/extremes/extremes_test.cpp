#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "point.hpp"
#include "strands.hpp"
#include "strandyn/extremes/extreme.hpp"
#include "strandyn/section/return_map.hpp"

using namespace strandyn;
using extremes::Extreme;
using extremes::Found;
using extremes::Measure;

namespace {

std::string told(const extremes::Row& row) {
  std::string words = row.extreme.name + ": " + row.error;
  for (const Measure& m : row.found.measures) words += "\n  " + m.words();
  return words;
}

/// The planar return map, but for a part of its loss that nobody books.
class Forgetful final : public section::Law {
 public:
  explicit Forgetful(double kept) : kept_(kept) {}
  std::string_view name() const override { return "forgetful"; }
  section::Dimension dimension() const override { return law_.dimension(); }
  section::History start(const section::Field& strains) const override { return law_.start(strains); }
  section::Effort respond(const section::History& history, const section::Field& strains, section::Field& stresses,
                          section::TangentField* tangents) const override {
    return law_.respond(history, strains, stresses, tangents);
  }
  section::Effort commit(section::History& history, const section::Field& strains,
                         section::StepEnergy& energy) const override {
    const section::Effort effort = law_.commit(history, strains, energy);
    energy.dissipated[0] *= kept_;
    return effort;
  }

 private:
  section::PlanarReturnMap law_{extremes::curlew(), 36};
  double kept_;
};

bool account_holds(const section::Law& law) {
  Found found;
  add_account(extremes::walk(law, extremes::cycles(extremes::strain_at(0.15), 0.05, 40, 2)), found);
  return std::ranges::all_of(found.measures, &Measure::holds);
}

}  // namespace

TEST_CASE("extremes: at least sixty rows, each with a name of its own, what is extreme and what must hold") {
  std::set<std::string> names;
  for (const Extreme& row : extremes::all_extremes()) {
    CAPTURE(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(row.name.find('/') != std::string::npos);
    CHECK_FALSE(row.what.empty());
    CHECK_FALSE(row.bound.empty());
  }
  CHECK(names.size() >= 60);
}

TEST_CASE("extremes: the quick rows hold") {
  for (const Extreme& extreme : extremes::all_extremes()) {
    if (extreme.pace != extremes::Pace::quick) continue;
    const extremes::Row row = run_extreme(extreme);
    CHECK_MESSAGE(row.passed(), told(row));
    CHECK_MESSAGE(row.found.cost.ordinary > 0, told(row));
  }
}

TEST_CASE("extremes: a number that is not finite holds nowhere") {
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_FALSE(Measure{.what = "unbounded", .value = value}.holds());
    CHECK_FALSE(Found{}.most("bounded", value, 1).measures.front().holds());
  }
  CHECK(Found{}.within("inside", 1, 0, 2).measures.front().holds());
  CHECK_FALSE(Found{}.within("outside", 3, 0, 2).measures.front().holds());
  CHECK_FALSE(Found{}.close("near", 1.1, 1, 0.05).measures.front().holds());
}

TEST_CASE("extremes: a row that throws or measures nothing has failed") {
  const auto throws = []() -> Found { throw std::runtime_error("no equilibrium"); };
  const extremes::Row thrown = extremes::run_extreme({.name = "a/b", .what = "", .bound = "", .run = throws});
  CHECK_FALSE(thrown.passed());
  CHECK(thrown.error == "no equilibrium");
  CHECK_FALSE(extremes::run_extreme({.name = "a/c", .what = "", .bound = "", .run = [] { return Found{}; }}).passed());
}

TEST_CASE("extremes: a law that books a millionth of its loss too little breaks the account") {
  CHECK(account_holds(Forgetful(1)));
  CHECK_FALSE(account_holds(Forgetful(1 - 1e-6)));
  CHECK_FALSE(account_holds(Forgetful(-1)));
}

TEST_CASE("extremes: names select rows by a part, and are told before they run") {
  std::vector<std::string> heard;
  const auto rows = extremes::run_extremes({"tension/slack"}, [&](const std::string& name) { heard.push_back(name); });
  REQUIRE(rows.size() == 2);
  CHECK(heard == std::vector<std::string>{"tension/slack", "tension/slack-pressed"});
  CHECK(rows[0].passed());
  CHECK(extremes::run_extremes({"no such row"}, {}).empty());
}
