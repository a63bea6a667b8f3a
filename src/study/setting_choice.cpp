#include "setting_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/build/section_law.hpp"
#include "strandyn/build/span.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

constexpr int most_rounds = 8;
/// Times the elements and the steps begun with; beyond, the run says what it has not reached.
constexpr int most_finer = 4;

/// The next even number: half as many steps are run, too.
int even(double x) {
  return 2 * static_cast<int>(std::ceil(x / 2));
}

}  // namespace

SettingChoice::SettingChoice(const Scene& asked, double target, LossRun run)
    : asked_(asked), target_(target), run_(std::move(run)), scene_(asked) {
  scene_.accuracy.reset();
  if (is_free("integrator.method")) scene_.integrator.method = casefile::Method::generalized_alpha;
  if (fits_frequency()) scene_.integrator.fits_frequency = true;
  begin();
}

/// A bench tunes its drive to the resonance that it finds, whatever a step does to it, and a decay has no drive.
bool SettingChoice::fits_frequency() const {
  return is_free("integrator.fit_frequency") && scene_.integrator.method == casefile::Method::generalized_alpha &&
         scene_.is<casefile::ForcedAnalysis>();
}

bool SettingChoice::points_are_free() const {
  return is_free("section.points") && build::slips_by_points(asked_.section.law);
}

/// What has met the target on many scenes.
void SettingChoice::begin() {
  setting_.steps_per_cycle = even(6.5 / std::sqrt(target_));
  if (!scene_.is<casefile::DecayAnalysis>()) {
    // The step lowers frequencies by the share 3.3/s^2. Against a damping ratio z that detunes a resonance, whose
    // amplitude at the crest falls by (3.3/(s^2 z))^2/2 and whose friction by three times as much. A bench is tuned to
    // its resonance and held at its amplitude; left is the third harmonic near a mode of its own, which the step
    // detunes nine times as much and which has a tenth of the loss. Steps fitted to the drive leave that, too; a force
    // at one place wakes less of it.
    constexpr double damping_ratio = 4e-3;  // of ordinary self-damping
    const bool is_forced = scene_.is<casefile::ForcedAnalysis>();
    const bool is_tuned = !is_forced || scene_.integrator.fits_frequency;
    const double harmonic = is_tuned ? 3 : 1, share = !is_tuned ? 1 : is_forced ? 0.02 : 0.1;
    const double steps = harmonic * std::sqrt(3.3 / damping_ratio) * std::pow(1.5 * share / target_, 0.25);
    setting_.steps_per_cycle = std::max(setting_.steps_per_cycle, even(steps));
  }
  setting_.points = !points_are_free() ? asked_.section.points : target_ >= 0.05 ? 20 : 36;
  if (!steps_are_free()) setting_.steps_per_cycle = *asked_.integrator.steps_per_cycle;
  Scene meshed = scene_;
  if (elements_are_free()) meshed.span->elements_per_loop = 2.6 / std::pow(target_, 0.14);
  const auto elements = static_cast<int>(build::build_span(meshed).model.elements.size());
  setting_.elements = elements_are_free() ? std::max(elements, 8) : elements;
  first_ = setting_;
}

ErrorEstimate SettingChoice::search(const Hooks& hooks, Cost& cost) {
  Stretch stretch(scene_, first_, mesh_ratio(), hooks, run_);
  std::optional<ErrorEstimate> estimate;
  for (int round = 0; round < most_rounds; ++round) {
    estimate = stretch.estimate(setting_);
    if (!estimate) throw Interrupted("interrupted while the error was estimated");
    if (estimate->relative() <= target_ || !refine(*estimate)) break;
  }
  cost.add(stretch.cost());
  estimate->target = target_;
  return *estimate;
}

double SettingChoice::mesh_ratio() const {
  constexpr double wide_target = 0.05;
  return target_ >= wide_target ? 2 : std::numbers::sqrt2;
}

/// Refines each part that takes more than its share of the target, of what the case has left open; else the largest.
bool SettingChoice::refine(const ErrorEstimate& estimate) {
  constexpr double share = 0.5, by_order = 1 / 1.75;
  constexpr double least = std::numbers::sqrt2, most = 2 * std::numbers::sqrt2;
  const double mesh = elements_are_free() && setting_.elements < most_finer * first_.elements ? estimate.mesh : 0;
  const double time =
      steps_are_free() && setting_.steps_per_cycle < most_finer * first_.steps_per_cycle ? estimate.time : 0;
  const std::optional<int> finer = build::finer_points(setting_.points);
  const double points = points_are_free() && finer ? estimate.points.value_or(0) : 0;
  const double largest = std::max({mesh, time, points});
  if (largest == 0) return false;
  const double allowed = std::min(share * target_, largest);
  if (mesh >= allowed) {
    // Errors of the mesh fall by steps: a mode is carried or it is not.
    const double factor = std::clamp(std::sqrt(mesh / allowed), 1.2, 2.0);
    setting_.elements =
        std::min(static_cast<int>(std::lround(setting_.elements * factor)), most_finer * first_.elements);
  }
  if (time >= allowed) {
    const double factor = std::clamp(std::pow(time / allowed, by_order), least, most);
    setting_.steps_per_cycle = std::min(even(setting_.steps_per_cycle * factor), most_finer * first_.steps_per_cycle);
  }
  if (points >= allowed) setting_.points = *finer;
  return true;
}

ChosenKeys SettingChoice::keys() const {
  ChosenKeys keys;
  if (elements_are_free()) keys.span.elements = setting_.elements;
  if (is_free("integrator.method")) keys.integrator.method = name_of(scene_.integrator.method);
  if (fits_frequency()) keys.integrator.fit_frequency = true;
  if (steps_are_free()) keys.integrator.steps_per_cycle = setting_.steps_per_cycle;
  if (points_are_free()) keys.section.points = setting_.points;
  return keys;
}

}  // namespace strandyn::study
