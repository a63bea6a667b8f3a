#pragma once
/// \file What a tradeoff tells of its settings, and how they are measured against the reference.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/results/record.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// One combination, and what came of it. `error` is relative to the reference, with its sign; where the reference is
/// zero it is the value itself.
struct SettingRow {
  std::size_t number = 0;
  std::string status{};
  std::optional<std::string> message{};
  std::optional<double> value{}, error{}, cost_ratio{};
  double section_evaluations = 0, cpu = 0;
  bool is_reference = false, within_reference = false, on_frontier = false;
};
template <class V>
void members(V& v, SettingRow& r) {
  v.value("number", r.number, {.what = "of the setting; 0 is the reference"});
  v.value("status", r.status, {.what = "of its run: done or failed"});
  v.value("message", r.message, {.what = "why it failed"});
  v.value("value", r.value, {.what = "the quantity"});
  v.value("error", r.error, {.what = "relative to the reference, with its sign; the value itself where that is 0"});
  v.value("cost_ratio", r.cost_ratio,
          {.what = "section evaluations over those of the reference; CPU time without any"});
  v.value("section_evaluations", r.section_evaluations, {.what = "of its run"});
  v.value("cpu_s", r.cpu, {.what = "of its run"});
  v.value("is_reference", r.is_reference, {.what = "whether it is what the others are measured against"});
  v.value("within_reference", r.within_reference, {.what = "the error is smaller than what is sure of the reference"});
  v.value("on_frontier", r.on_frontier, {.what = "no other setting is both cheaper and nearer"});
}

/// What the reference does when one knob goes back to the value before its last.
struct ReferenceMove {
  std::string key;
  std::optional<double> change{};
};
template <class V>
void members(V& v, ReferenceMove& m) {
  v.value("key", m.key, {.what = "the knob"});
  v.value("change", m.change, {.what = "of the quantity, relative, when it alone goes back by one value"});
}

struct Reference {
  double value = 0;
  std::optional<double> moved{};
  std::vector<ReferenceMove> moved_by{};
};
template <class V>
void members(V& v, Reference& r) {
  v.value("value", r.value, {.what = "the quantity with the last value of every knob", .shown = "reference"});
  v.value("moved", r.moved,
          {.what = "sum of the changes by single knobs: what is sure of it", .shown = "reference moved by its knobs"});
  v.list("moved_by", r.moved_by, {.what = "knob by knob"});
}

/// The cheapest setting whose error, and what is unsure of the reference, stay below the target.
struct CheapestRow {
  double target = 0;
  bool reference_is_sure = false;
  std::optional<std::size_t> number{};
  std::optional<double> error{}, cost_ratio{};
};
template <class V>
void members(V& v, CheapestRow& c) {
  v.value("target", c.target, {.what = "relative error"});
  v.value("reference_is_sure", c.reference_is_sure, {.what = "the reference has moved by less than a fifth of it"});
  v.value("number", c.number, {.what = "of the setting; none where none is near enough"});
  v.value("error", c.error, {.what = "its error"});
  v.value("cost_ratio", c.cost_ratio, {.what = "its cost"});
}

struct TradeoffSummary {
  std::string quantity{};
  std::optional<Reference> reference{};
  std::vector<SettingRow> points{};
  std::vector<CheapestRow> cheapest{};
};
template <class V>
void members(V& v, TradeoffSummary& s) {
  v.value("quantity", s.quantity, {.what = "whose error counts"});
  v.record("reference", s.reference, {.what = "what the others are measured against"});
  v.list("points", s.points, {.what = "the settings, each with `settings`, the value of every knob"});
  v.list("cheapest", s.cheapest, {.what = "for every target"});
}

/// Where the reference goes when the knob alone goes back by one value: the number of that setting.
struct StepBack {
  std::string key;
  std::size_t number = 0;
};

/// Fills errors, costs, the frontier and the cheapest settings; the first row is the reference, and has a value. Of the
/// reference only, while not all settings have run.
void measure(const std::vector<StepBack>& steps, const std::vector<double>& targets, bool complete,
             TradeoffSummary& summary, Outcome& outcome);

/// Of tradeoff.csv and frontier.csv; a line goes along the first knob, the columns of the others name it.
void add_tradeoff_figures(const std::vector<std::string>& other_knobs, Outcome& outcome);

}  // namespace strandyn::study
