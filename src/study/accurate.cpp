#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "entries.hpp"
#include "setting_choice.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

struct AccuracySummary {
  std::optional<ErrorEstimate> estimate{};
  ChosenKeys chosen{};
};
template <class V>
void members(V& v, AccuracySummary& s) {
  v.record("error_estimate", s.estimate, {.what = "of the dissipation"});
  v.record("chosen", s.chosen, {.what = "what the program has chosen for the accuracy, by key"});
}

class Accurate final : public Analysis {
 public:
  explicit Accurate(const Scene& asked) : target_(*casefile::target_error(asked)), choice_(asked, target_) { choose(); }

  const Scene* base() const override { return &chosen_; }

  Outlook outlook() override {
    const std::clock_t start = std::clock();
    Outlook outlook = inner_->outlook();
    const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const double one_run = std::sqrt(outlook.evaluations_least * outlook.evaluations_most);
    // How often mesh or step are to be refined shows in the run only; where wires slip, that grew like this, as the
    // middle of twofold either way.
    constexpr double by_target = 0.36, twofold = 1.9;
    const Hooks nobody;
    const double once = 1 + Stretch(chosen_, choice_.setting(), choice_.mesh_ratio(), nobody).share_of_first();
    const bool refines = casefile::number_at("vibration.friction_of_half_a_cycle_J", outlook.modelled).value_or(0) > 0;
    const double refined = refines ? std::pow(0.1 / target_, by_target) : 1;
    outlook.evaluations_least *= once * refined / (refines ? twofold : 1);
    outlook.evaluations_most *= once * refined * (refines ? twofold : 1);
    // Of decays: modes and rest, for each of the short runs, on meshes of half as many elements or so. What has just
    // been taken is that and the trial's cycles.
    if (chosen_.is<casefile::DecayAnalysis>() && one_run > 0) {
      constexpr double runs = 8, part_of_mesh = 0.6, more_runs = 1.5, trial_cycles = 3.5;
      const double cycles = std::max(1.0, casefile::number_at("vibration.cycles", outlook.modelled).value_or(1));
      const double begun = std::max(0.0, took - trial_cycles / cycles * one_run * outlook.seconds_per_evaluation);
      outlook.seconds_per_evaluation +=
          runs * part_of_mesh * (refines ? more_runs : 1) * begun / (one_run * once * refined);
    }
    outlook.modelled.merge(results::to_value(AccuracySummary{.chosen = choice_.keys()}));
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    Cost cost;
    const ErrorEstimate estimate = choice_.search(hooks, cost);
    if (choice_.is_refined()) choose();
    inner_->run(hooks, outcome);
    outcome.cost.add(cost);
    if (std::isfinite(estimate.relative())) {
      outcome.findings.push_back(
          fmt::format("The dissipation is within an estimated {:.2g} % of the converged one ({:.2g} % were asked for).",
                      100 * estimate.relative(), 100 * target_));
    }
    outcome.tell(AccuracySummary{.estimate = estimate, .chosen = choice_.keys()});
    if (estimate.relative() > target_) outcome.warnings.push_back(words_of(estimate));
  }

 private:
  void choose() {
    chosen_ = choice_.scene();
    inner_ = prepare(chosen_);
  }
  std::string words_of(const ErrorEstimate& estimate) const {
    const char* kept = choice_.keeps_a_knob() ? "; the case sets some of them itself" : "";
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

  double target_;
  SettingChoice choice_;
  Scene chosen_;
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
