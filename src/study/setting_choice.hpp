#pragma once
/// \file Mesh, steps and points of a vibration, chosen for an accuracy: refined until the estimated error is below it.

#include "accuracy.hpp"

namespace strandyn::study {

/// `chosen` of summary.json: the keys that the case has left to the program.
struct ChosenKeys {
  struct Span {
    std::optional<int> elements{};
  } span{};
  struct Integrator {
    std::optional<std::string> method{};
    std::optional<bool> fit_frequency{};
    std::optional<int> steps_per_cycle{};
  } integrator{};
  struct Section {
    std::optional<int> points{};
  } section{};
};
template <class V>
void members(V& v, ChosenKeys::Span& s) {
  v.value("elements", s.elements, {.what = "of the span", .shown = "chosen elements"});
}
template <class V>
void members(V& v, ChosenKeys::Integrator& i) {
  v.value("method", i.method, {.what = "of the integration in time"});
  v.value("fit_frequency", i.fit_frequency, {.what = "whether steps keep the frequency of the drive"});
  v.value("steps_per_cycle", i.steps_per_cycle, {.what = "of the integration", .shown = "chosen steps per cycle"});
}
template <class V>
void members(V& v, ChosenKeys::Section& s) {
  v.value("points", s.points, {.what = "of a turn of the lay"});
}
template <class V>
void members(V& v, ChosenKeys& c) {
  v.record("span", c.span, {.what = "keys of [span]"});
  v.record("integrator", c.integrator, {.what = "keys of [integrator]"});
  v.record("section", c.section, {.what = "keys of [section]"});
}

class SettingChoice {
 public:
  /// A decay or a forced vibration, or what `run` does, a test bench; the scene must outlive this. What its file sets
  /// is kept.
  SettingChoice(const casefile::Scene& asked, double target, LossRun run = {});

  /// The scene with what is chosen so far; it asks for no accuracy.
  casefile::Scene scene() const { return with_setting(scene_, setting_); }
  /// Refines what gives the largest part of the error, until their sum is below the target or nothing is left that the
  /// case leaves open. The work is added to `cost`. Throws Interrupted.
  ErrorEstimate search(const Hooks& hooks, Cost& cost);
  bool is_refined() const { return setting_ != first_; }
  const Setting& setting() const { return setting_; }
  double mesh_ratio() const;  ///< [-] of the meshes that the estimate compares
  ChosenKeys keys() const;
  bool keeps_a_knob() const { return !elements_are_free() || !steps_are_free() || !points_are_free(); }

 private:
  bool is_free(std::string_view key) const { return !asked_.source.find(key); }
  bool elements_are_free() const { return !asked_.span->elements; }
  bool steps_are_free() const { return is_free("integrator.steps_per_cycle"); }
  bool fits_frequency() const;
  bool points_are_free() const;
  void begin();
  bool refine(const ErrorEstimate& estimate);

  const casefile::Scene& asked_;  // its file says what is kept
  double target_;
  LossRun run_;
  casefile::Scene scene_;  ///< without what is chosen
  Setting first_, setting_;
};

}  // namespace strandyn::study
