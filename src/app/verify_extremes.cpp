#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "strandyn/extremes/extreme.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/version.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace strandyn::extremes {

// The members of `verify extremes --json`.
template <class V>
void members(V& v, Measure& m) {
  const auto finite = [](double x) { return std::isfinite(x) ? std::optional<double>(x) : std::nullopt; };
  std::optional<double> value = finite(m.value), low = finite(m.at_least), high = finite(m.at_most);
  bool holds = m.holds();
  v.value("what", m.what, {.what = "was measured"});
  v.value("value", value, {.what = "what was found; missing where it is not finite"});
  v.value("at_least", low, {.what = "the bound from below"});
  v.value("at_most", high, {.what = "the bound from above"});
  v.value("holds", holds, {.what = "whether it lies there"});
}

}  // namespace strandyn::extremes

namespace strandyn::app {
namespace {

using extremes::Measure;
using extremes::Row;

struct JsonRow {
  std::string name, extreme, bound;
  std::vector<Measure> found;
  std::optional<double> cost_ratio{};
  std::optional<std::string> cost_unit{};
  double cpu_s = 0;
  bool passed = false;
  std::optional<std::string> error{};
};
template <class V>
void members(V& v, JsonRow& r) {
  v.value("name", r.name, {.what = "of the row"});
  v.value("extreme", r.extreme, {.what = "what is extreme"});
  v.value("bound", r.bound, {.what = "what physics demands"});
  v.list("found", r.found, {.what = "what was measured"});
  v.value("cost_ratio", r.cost_ratio, {.what = "cost over that of the ordinary case"});
  v.value("cost_unit", r.cost_unit, {.what = "in what the cost is counted"});
  v.value("cpu_s", r.cpu_s, {.what = "time of all processors for the row, its ordinary case included"});
  v.value("passed", r.passed, {.what = "whether all holds"});
  v.value("error", r.error, {.what = "why nothing was found"});
}
JsonRow json_of(const Row& row) {
  JsonRow r{.name = row.extreme.name,
            .extreme = row.extreme.what,
            .bound = row.extreme.bound,
            .found = row.found.measures,
            .cpu_s = row.cpu_s,
            .passed = row.passed()};
  if (row.found.cost.ordinary > 0) {
    r.cost_ratio = row.found.cost.ratio();
    r.cost_unit = row.found.cost.unit;
  }
  if (!row.error.empty()) r.error = row.error;
  return r;
}

std::string cost_words(const Row& row) {
  const extremes::Cost& cost = row.found.cost;
  return cost.ordinary > 0 ? fmt::format("{:.3g} ({})", cost.ratio(), cost.unit) : "-";
}

/// All that was found, or why nothing was; what breaks its bound says so.
std::string found_words(const Row& row, const char* between) {
  std::string words;
  for (const Measure& m : row.found.measures) {
    words += fmt::format("{}{}{}", words.empty() ? "" : between, m.words(), m.holds() ? "" : " FAILED");
  }
  if (!row.error.empty()) words += (words.empty() ? "" : between) + row.error;
  return words;
}

void print_row(const Row& row) {
  print("\n{}: {}\n  {}\n  must hold  {}\n  found      {}\n  cost       {} of the ordinary case\n", row.extreme.name,
        row.passed() ? "passed" : "FAILED", row.extreme.what, row.extreme.bound, found_words(row, "\n             "),
        cost_words(row));
}

void print_markdown(const std::vector<Row>& rows) {
  std::string theme;
  for (const Row& row : rows) {
    const std::string here = row.extreme.name.substr(0, row.extreme.name.find('/'));
    if (here != theme) {
      print(
          "\n## {}\n\n| row | what is extreme | what must hold | found | cost |  |\n| --- | --- | --- | --- | ---: | "
          "--- |\n",
          here);
      theme = here;
    }
    print("| {} | {} | {} | {} | {} | {} |\n", row.extreme.name.substr(theme.size() + 1), row.extreme.what,
          row.extreme.bound, found_words(row, "<br>"), cost_words(row), row.passed() ? "passed" : "**FAILED**");
  }
}

}  // namespace

ExitCode verify_extremes(const VerifyArguments& arguments) {
  const std::vector<std::string> names(arguments.names.begin() + 1, arguments.names.end());
  const std::vector<Row> rows =
      extremes::run_extremes(names, [](const std::string& name) { tell("running {}\n", name); });
  if (rows.empty()) throw InputError("no row of the extremes has such a name; `strandyn verify extremes` names all");
  const auto passed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.passed(); });
  if (arguments.json) {
    std::vector<JsonRow> list;
    for (const Row& row : rows) list.push_back(json_of(row));
    print_raw(results::to_text(results::to_value(list)) + '\n');
  } else if (arguments.markdown) {
    print_markdown(rows);
    print("\n{} of {} rows hold (strandyn {}, {}).\n", passed, rows.size(), program_version, program_revision);
  } else {
    for (const Row& row : rows) print_row(row);
    print("\n{} of {} extremes hold\n", passed, rows.size());
  }
  return passed == static_cast<std::ptrdiff_t>(rows.size()) ? ExitCode::done : ExitCode::not_converged;
}

}  // namespace strandyn::app
