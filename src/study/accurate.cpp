#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy.hpp"
#include "entries.hpp"
#include "strandyn/build/span.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

constexpr int most_rounds = 12;
/// Times the elements and the steps begun with; beyond, the run says what it has not reached.
constexpr int most_finer = 4;

/// `chosen` of summary.json: the keys that the case has left to the program.
struct ChosenKeys {
  struct Span {
    std::optional<int> elements{};
  } span{};
  struct Integrator {
    std::optional<std::string> method{};
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

struct AccuracySummary {
  std::optional<ErrorEstimate> estimate{};
  ChosenKeys chosen{};
};
template <class V>
void members(V& v, AccuracySummary& s) {
  v.record("error_estimate", s.estimate, {.what = "of the dissipation"});
  v.record("chosen", s.chosen, {.what = "what the program has chosen for the accuracy, by key"});
}

/// The next even number: half as many steps are run, too.
int even(double x) {
  return 2 * static_cast<int>(std::ceil(x / 2));
}

class Accurate final : public Analysis {
 public:
  explicit Accurate(const Scene& asked) : asked_(asked), target_(*casefile::target_error(asked)), scene_(asked) {
    scene_.accuracy.reset();
    if (is_free("integrator.method")) scene_.integrator.method = casefile::Method::generalized_alpha;
    begin();
    choose(setting_);
  }

  const Scene* base() const override { return &chosen_; }

  Outlook outlook() override {
    Outlook outlook = inner_->outlook();
    // How often mesh or step are to be refined shows in the run only.
    constexpr double estimated_once = 2, refined = 7.5;
    outlook.evaluations_least *= estimated_once;
    outlook.evaluations_most *= refined;
    outlook.modelled.merge(results::to_value(AccuracySummary{.chosen = chosen_keys()}));
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    Stretch stretch(scene_, hooks);
    std::optional<ErrorEstimate> estimate;
    for (int round = 0; round < most_rounds; ++round) {
      estimate = stretch.estimate(setting_);
      if (!estimate) throw Interrupted("interrupted while the error was estimated");
      if (estimate->relative() <= target_ || !refine(*estimate)) break;
    }
    estimate->target = target_;
    if (setting_ != first_) choose(setting_);
    inner_->run(hooks, outcome);
    outcome.cost.add(stretch.cost());
    outcome.tell(AccuracySummary{.estimate = estimate, .chosen = chosen_keys()});
    if (estimate->relative() > target_) outcome.warnings.push_back(words_of(*estimate));
  }

 private:
  bool is_free(std::string_view key) const { return !asked_.source.find(key); }
  bool elements_are_free() const { return !asked_.span->elements; }
  bool steps_are_free() const { return is_free("integrator.steps_per_cycle"); }
  bool points_are_free() const { return is_free("section.points") && build::slips_by_points(asked_.section.law); }
  std::string words_of(const ErrorEstimate& estimate) const {
    const char* kept = keeps_a_knob() ? "; the case sets some of them itself" : "";
    if (!std::isfinite(estimate.relative())) {
      return fmt::format(
          "what the dissipation is off by is not known: half the elements or half the steps cannot be run{}", kept);
    }
    return fmt::format(
        "the dissipation may be off by {:.2g} %, and {:.2g} % were asked for: mesh {:.2g}, steps {:.2g}, points {:.2g} "
        "%{}",
        100 * estimate.relative(), 100 * target_, 100 * estimate.mesh, 100 * estimate.time,
        100 * estimate.points.value_or(0), kept);
  }
  bool keeps_a_knob() const { return !elements_are_free() || !steps_are_free() || !points_are_free(); }

  /// What has met the target on many scenes.
  void begin() {
    setting_.steps_per_cycle = even(6.5 / std::sqrt(target_));
    if (scene_.is<casefile::ForcedAnalysis>()) {
      // The step lowers frequencies by the share 3.3/s^2. Against a damping ratio z that detunes a resonance, whose
      // amplitude at the crest falls by (3.3/(s^2 z))^2/2 and whose friction by three times as much.
      constexpr double damping_ratio = 4e-3;  // of ordinary self-damping
      setting_.steps_per_cycle =
          std::max(setting_.steps_per_cycle, even(std::sqrt(3.3 / damping_ratio) * std::pow(1.5 / target_, 0.25)));
    }
    setting_.points = !points_are_free() ? asked_.section.points : target_ >= 0.05 ? 20 : 36;
    if (!steps_are_free()) setting_.steps_per_cycle = *asked_.integrator.steps_per_cycle;
    Scene meshed = scene_;
    if (elements_are_free()) meshed.span->elements_per_loop = 2.6 / std::pow(target_, 0.14);
    const auto elements = static_cast<int>(build::build_span(meshed).model.elements.size());
    setting_.elements = elements_are_free() ? std::max(elements, 8) : elements;
    first_ = setting_;
  }

  void choose(const Setting& setting) {
    chosen_ = with_setting(scene_, setting);
    inner_ = prepare(chosen_);
  }

  /// Refines what gives the largest part of the error, of what the case has left open. False where nothing is left.
  bool refine(const ErrorEstimate& estimate) {
    const double mesh = elements_are_free() && setting_.elements < most_finer * first_.elements ? estimate.mesh : 0;
    const double time =
        steps_are_free() && setting_.steps_per_cycle < most_finer * first_.steps_per_cycle ? estimate.time : 0;
    const std::optional<int> finer = build::finer_points(setting_.points);
    const double points = points_are_free() && finer ? estimate.points.value_or(0) : 0;
    const double largest = std::max({mesh, time, points});
    if (largest == 0) return false;
    // As much finer as a part of order two has to become, if it alone is to make up for all that is too much; errors of
    // the mesh are of higher order.
    const double wanted = std::isfinite(largest) ? (estimate.relative() - target_) / largest : 1;
    const double factor = std::clamp(1 / std::sqrt(std::max(1 - 1.1 * wanted, 0.01)), 1.15, 2.5);
    if (mesh == largest) {
      const auto elements = static_cast<int>(std::ceil(setting_.elements * std::clamp(std::sqrt(factor), 1.2, 1.5)));
      setting_.elements = std::min(elements, most_finer * first_.elements);
    } else if (time == largest) {
      setting_.steps_per_cycle = std::min(even(setting_.steps_per_cycle * factor), most_finer * first_.steps_per_cycle);
    } else {
      setting_.points = *finer;
    }
    return true;
  }

  ChosenKeys chosen_keys() const {
    ChosenKeys keys;
    if (elements_are_free()) keys.span.elements = setting_.elements;
    if (is_free("integrator.method")) keys.integrator.method = name_of(scene_.integrator.method);
    if (steps_are_free()) keys.integrator.steps_per_cycle = setting_.steps_per_cycle;
    if (points_are_free()) keys.section.points = setting_.points;
    return keys;
  }

  const Scene& asked_;
  double target_;
  Scene scene_;  ///< without what is chosen
  Scene chosen_;
  Setting first_, setting_;
  std::unique_ptr<Analysis> inner_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_accuracy() {
  return results::ReferenceWriter::of<AccuracySummary>();
}

std::unique_ptr<Analysis> prepare_accurate(const Scene& scene) {
  return std::make_unique<Accurate>(scene);
}

}  // namespace strandyn::study
