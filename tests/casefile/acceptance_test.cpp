#include "strandyn/casefile/acceptance.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "strandyn/results/json.hpp"
#include "support/check_close.hpp"

using namespace strandyn::casefile;
using strandyn::results::Value;
using strandyn::test::check_close;

namespace {

const Value summary = strandyn::results::from_text(R"({
  "status": "done",
  "steady": {"damping_ratio": 0.00121, "converged": true, "numerical_share": null},
  "loops": [{"area_J_per_m": 1.5}, {"area_J_per_m": 4.0}],
  "cycles": [{"x": 3}, {"x": -7}, {"x": 2}],
  "ragged": [{"x": 3}, {"y": 1}],
  "nested": [{"v": [1, 2]}, {"v": [5, 4]}],
  "frequencies_Hz": [1.0, 2.5],
  "empty": []
})",
                                                   "the test");

Verdict verdict_of(Criterion criterion, int exit_code = 0) {
  criterion.reason = "a reason";
  return judge({{criterion}}, summary, exit_code).at(0);
}

double value_at(const std::string& path) {
  const Verdict verdict = verdict_of({.path = path, .below = 1e300});
  CAPTURE(path);
  CAPTURE(verdict.found);
  REQUIRE(verdict.got);
  return *verdict.got;
}

std::string fault_at(const std::string& path) {
  const Verdict verdict = verdict_of({.path = path, .below = 1e300});
  CHECK_FALSE(verdict.passed);
  CHECK_FALSE(verdict.got.has_value());
  return verdict.found;
}

}  // namespace

TEST_CASE("a path leads through tables and lists to a number") {
  CHECK(value_at("steady.damping_ratio") == 0.00121);
  CHECK(value_at("loops[1].area_J_per_m") == 4.0);
  CHECK(value_at("cycles[-1].x") == 2.0);
  CHECK(value_at("cycles[-3].x") == 3.0);
  CHECK(value_at("frequencies_Hz[0]") == 1.0);
  CHECK(value_at("nested[1].v[0]") == 5.0);
}

TEST_CASE("max, min and sum run over a list, also one within the other") {
  CHECK(value_at("cycles[max].x") == 3.0);
  CHECK(value_at("cycles[min].x") == -7.0);
  CHECK(value_at("cycles[sum].x") == -2.0);
  CHECK(value_at("frequencies_Hz[max]") == 2.5);
  CHECK(value_at("nested[min].v[max]") == 2.0);
  CHECK(value_at("nested[sum].v[sum]") == 12.0);
}

TEST_CASE("a path that leads nowhere is a failed verdict that says where it ended") {
  CHECK(fault_at("steady.loss_factor") == "`steady` has no `loss_factor`");
  CHECK(fault_at("staedy.loss_factor") == "the summary has no `staedy`");
  CHECK(fault_at("cycles[3].x") == "`cycles` has 3 elements, no [3]");
  CHECK(fault_at("cycles[-4].x") == "`cycles` has 3 elements, no [-4]");
  CHECK(fault_at("ragged[max].x") == "`ragged[1]` has no `x`");
  CHECK(fault_at("empty[sum]") == "`empty` is an empty list");
  CHECK(fault_at("empty[0]") == "`empty` has 0 elements, no [0]");
  CHECK(fault_at("steady[0]") == "`steady` is no list");
  CHECK(fault_at("cycles.x") == "`cycles` has no `x`");
  CHECK(fault_at("steady") == "`steady` is an object, no number");
  CHECK(fault_at("steady.numerical_share") == "`steady.numerical_share` is null, no number");
}

TEST_CASE("a path that cannot be spelled has a fault, one that can has none") {
  for (const char* path : {"", ".", "a.", ".a", "a..b", "a[", "a[1", "a[]", "a[x]", "a[1.5]", "a]b", "[1]", "a[1]b"}) {
    CAPTURE(path);
    CHECK(find_path_fault(path).has_value());
    fault_at(path);
  }
  CHECK_FALSE(find_path_fault("cycles[max].x").has_value());
  CHECK_FALSE(find_path_fault("exit_code").has_value());
}

TEST_CASE("an expected value holds to the relative or the absolute deviation, and no further") {
  const auto relative = [](double allowed) {
    return verdict_of({.path = "steady.damping_ratio", .expected = 1.2e-3, .relative = allowed});
  };
  CHECK(relative(0.0084).passed);
  CHECK_FALSE(relative(0.0083).passed);  // it is off by 0.833 %
  const auto absolute = [](double allowed) {
    return verdict_of({.path = "steady.damping_ratio", .expected = 1.2e-3, .absolute = allowed});
  };
  CHECK(absolute(1.01e-5).passed);
  CHECK_FALSE(absolute(0.99e-5).passed);
  CHECK(relative(0.02).wanted == "0.0012 within 2 %");
  CHECK(absolute(0.02).wanted == "0.0012 within 0.02");
  CHECK(relative(0.02).found == "0.00121");
  check_close(relative(0.02).digits.value(), 2.0791812460476247, {.absolute = 1e-9});  // log10(120)
  CHECK(verdict_of({.path = "cycles[0].x", .expected = 3.0, .absolute = 0.0}).digits == 17.0);
}

TEST_CASE("a bound is not met by the bound itself") {
  CHECK(verdict_of({.path = "cycles[0].x", .below = 3.1}).passed);
  CHECK_FALSE(verdict_of({.path = "cycles[0].x", .below = 3.0}).passed);
  CHECK(verdict_of({.path = "cycles[0].x", .above = 2.9}).passed);
  CHECK_FALSE(verdict_of({.path = "cycles[0].x", .above = 3.0}).passed);
  CHECK(verdict_of({.path = "cycles[0].x", .above = 3.0}).wanted == "above 3");
}

TEST_CASE("the exit code can be asked for") {
  CHECK(verdict_of({.path = "exit_code", .expected = 3.0}, 3).passed);
  CHECK_FALSE(verdict_of({.path = "exit_code", .expected = 3.0}, 0).passed);
}

TEST_CASE("words and truths compare as they are, and a word is no number") {
  CHECK(verdict_of({.path = "status", .expected = std::string("done")}).passed);
  CHECK_FALSE(verdict_of({.path = "status", .expected = std::string("interrupted")}).passed);
  CHECK(verdict_of({.path = "steady.converged", .expected = true}).passed);
  CHECK_FALSE(verdict_of({.path = "steady.converged", .expected = false}).passed);
  const Verdict mixed = verdict_of({.path = "status", .expected = 1.0, .absolute = 1e9});
  CHECK_FALSE(mixed.passed);
  CHECK(mixed.found == "\"done\"");
  CHECK_FALSE(verdict_of({.path = "status", .below = 1.0}).passed);
}

TEST_CASE("a value that is no number at all fails every criterion") {
  Value broken;
  broken.set("x", std::numeric_limits<double>::quiet_NaN());
  Acceptance all;
  all.criteria.push_back({.path = "x", .below = 1.0});
  all.criteria.push_back({.path = "x", .above = 1.0});
  all.criteria.push_back({.path = "x", .expected = 1.0, .relative = 1e9});
  for (const Verdict& verdict : judge(all, broken, 0)) CHECK_FALSE(verdict.passed);
}

TEST_CASE("reductions go over all entries of a list that keeps its ends only") {
  Value list = Value::list();
  for (const double x : {1.0, 2.0, 9.0, 10.0}) {
    Value entry;
    entry.set("x", x);
    list.append(std::move(entry));
  }
  strandyn::results::Reductions all{.count = 10};
  all.members["x"] = {.least = -3, .largest = 40, .sum = 100};
  list.say_of_all(std::move(all));
  Value tree;
  tree.set("cycles", std::move(list));
  const auto at = [&](const std::string& path) {
    Acceptance one;
    one.criteria.push_back({.path = path, .below = 1e300});
    return judge(one, tree, 0).front();
  };
  CHECK(at("cycles[max].x").got == 40);
  CHECK(at("cycles[min].x").got == -3);
  CHECK(at("cycles[sum].x").got == 100);
  CHECK(at("cycles[1].x").got == 2);
  CHECK(at("cycles[-1].x").got == 10);
  CHECK(at("cycles[8].x").got == 9);
  CHECK_FALSE(at("cycles[5].x").got);
  CHECK(at("cycles[5].x").found.find("keeps the first and the last of 10") != std::string::npos);
}

TEST_CASE("each entry of the table gets its verdict, with reason and source") {
  Acceptance two;
  two.criteria.push_back({.path = "a", .below = 1.0, .reason = "first"});
  two.criteria.push_back({.path = "status", .expected = std::string("done"), .reason = "second", .source = "a paper"});
  const auto verdicts = judge(two, summary, 0);
  REQUIRE(verdicts.size() == 2);
  CHECK(verdicts[0].reason == "first");
  CHECK(verdicts[0].source.empty());
  CHECK(verdicts[1].source == "a paper");
  CHECK(verdicts[1].passed);
}
