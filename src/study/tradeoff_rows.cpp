#include "tradeoff_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/analysis/frontier.hpp"

namespace strandyn::study {

namespace {

/// The reference must be surer than what is measured against it, by this factor.
constexpr double surer = 5;

double scale_of(const Reference& reference) {
  return reference.value == 0 ? 1 : std::abs(reference.value);
}

Reference reference_of(const std::vector<SettingRow>& rows, const std::vector<StepBack>& steps) {
  Reference reference{.value = *rows.front().value};
  double moved = 0;
  for (const StepBack& step : steps) {
    ReferenceMove& move = reference.moved_by.emplace_back(ReferenceMove{.key = step.key});
    if (step.number >= rows.size() || !rows[step.number].value) return reference;
    move.change = (*rows[step.number].value - reference.value) / scale_of(reference);
    moved += std::abs(*move.change);
  }
  reference.moved = moved;
  return reference;
}

void compare(std::vector<SettingRow>& rows, const Reference& reference) {
  const SettingRow finest = rows.front();
  for (SettingRow& row : rows) {
    if (!row.value) continue;
    row.error = (*row.value - reference.value) / scale_of(reference);
    row.within_reference = !row.is_reference && std::abs(*row.error) < reference.moved.value_or(0);
    if (finest.section_evaluations > 0) {
      row.cost_ratio = row.section_evaluations / finest.section_evaluations;
    } else if (finest.cpu > 0) {
      row.cost_ratio = row.cpu / finest.cpu;
    }
  }
}

/// Why the reference is not sure enough for a target.
std::string doubt(const Reference& reference, double target) {
  if (!reference.moved) {
    return fmt::format(
        "the reference could not be compared to the values before its last: a target of {:g} % is not proven",
        100 * target);
  }
  return fmt::format(
      "the reference moves by {:.2g} % when its knobs go back by one value: too much to judge a target of {:g} % by "
      "it; "
      "give finer last values",
      100 * *reference.moved, 100 * target);
}

}  // namespace

void measure(const std::vector<StepBack>& steps, const std::vector<double>& targets, bool complete,
             TradeoffSummary& summary, Outcome& outcome) {
  std::vector<SettingRow>& rows = summary.points;
  const Reference& reference = summary.reference.emplace(reference_of(rows, steps));
  compare(rows, reference);
  if (!complete) return;

  // Those that may be chosen: they came to their end, and are not the reference itself.
  std::vector<analysis::Trade> trades;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].status != "done" || !rows[i].error || !rows[i].cost_ratio || rows[i].is_reference) continue;
    trades.push_back({.cost = *rows[i].cost_ratio, .error = std::abs(*rows[i].error)});
    numbers.push_back(i);
  }
  const std::vector<bool> best = analysis::frontier(trades);
  for (std::size_t i = 0; i < numbers.size(); ++i) rows[numbers[i]].on_frontier = best[i];

  for (const double target : targets) {
    CheapestRow& row = summary.cheapest.emplace_back(
        CheapestRow{.target = target, .reference_is_sure = reference.moved && *reference.moved < target / surer});
    if (const auto found = analysis::cheapest(trades, target, reference.moved.value_or(0))) {
      row.number = rows[numbers[*found]].number;
      row.error = rows[numbers[*found]].error;
      row.cost_ratio = rows[numbers[*found]].cost_ratio;
    }
    if (!row.reference_is_sure) outcome.warnings.push_back(doubt(reference, target));
  }
}

void add_tradeoff_figures(const std::vector<std::string>& other_knobs, Outcome& outcome) {
  outcome.figures.push_back({.name = "tradeoff",
                             .title = "Error against cost",
                             .table = "tradeoff.csv",
                             .x = "cost_ratio",
                             .y = {"error_size"},
                             .series = other_knobs,
                             .x_scale = "log",
                             .y_scale = "log",
                             .caption = "Each line goes along the first knob; cost in parts of the reference's."});
  outcome.figures.push_back({.name = "frontier",
                             .title = "The best at each cost",
                             .table = "frontier.csv",
                             .x = "cost_ratio",
                             .y = {"error_size"},
                             .x_scale = "log",
                             .y_scale = "log",
                             .caption = "Settings that no other one beats in both cost and error."});
}

}  // namespace strandyn::study
