/// \file A sweep that is as fine as an accuracy wants it.
///
/// The sweep's highest dissipation is that of the phase resonance at the amplitude A that the drive F holds up. Of a
/// resonance at a given amplitude the error is known (`periodic_accuracy`); at a given drive it is
///     e(F) = e(A) max(1, 1/s),   s = d ln F/d ln A
/// where A follows by a secant on half the mesh. Where s falls to nothing, friction holds no amplitude against that
/// drive, and no error is known. The steps along the curve leave
///     curve = |F_r/F - 1| max(1, 1/s)
/// with F_r the drive of the resonance at the amplitude that was read from the curve: the last one of the backbone.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "entries.hpp"
#include "strandyn/self_damping/periodic_accuracy.hpp"
#include "sweep.hpp"

namespace strandyn::study {

using casefile::Scene;
using self_damping::PeriodicAsk;
using self_damping::PeriodicSetting;

namespace {

/// `error_estimate` of a sweep.
struct SweepError {
  std::optional<double> relative{};
  double target = 0;
  std::optional<double> gain{}, mesh{}, harmonics{}, samples{}, points{}, curve{};
  double section_evaluations = 0;
};
template <class V>
void members(V& v, SweepError& e) {
  v.value("relative", e.relative,
          {.what = "of the dissipated power at phase resonance: the sum of the parts; absent where one is not known",
           .shown = "estimated error"});
  v.value("target", e.target, {.what = "that the case asks for"});
  v.value("gain", e.gain, {.what = "of an error at a given drive over the same at a given amplitude; among the parts"});
  v.value("mesh", e.mesh, {.what = "by the elements"});
  v.value("harmonics", e.harmonics, {.what = "by the harmonics of the motion"});
  v.value("samples", e.samples, {.what = "by the samples of a cycle"});
  v.value("points", e.points, {.what = "by the points of a section; absent where no wires slip"});
  v.value("curve", e.curve, {.what = "by the steps along the response"});
  v.value("section_evaluations", e.section_evaluations, {.what = "that the estimate took, among those of `cost`"});
}

/// `chosen`: the keys that the case has left to the program.
struct SweepChoice {
  self_damping::PointChoice knobs{};
  std::optional<double> swing_step{};
};
template <class V>
void members(V& v, SweepChoice& c) {
  v.value("elements", c.knobs.elements, {.what = "span.elements", .shown = "chosen elements"});
  v.value("harmonics", c.knobs.harmonics, {.what = "analysis.periodic.harmonics", .shown = "chosen harmonics"});
  v.value("samples", c.knobs.samples, {.what = "analysis.periodic.samples"});
  v.value("points", c.knobs.points, {.what = "section.points"});
  v.value("swing_step", c.swing_step, {.what = "analysis.swing_step"});
}

struct AccurateSweepSummary {
  std::optional<SweepError> estimate{};
  SweepChoice chosen{};
};
template <class V>
void members(V& v, AccurateSweepSummary& s) {
  v.record("error_estimate", s.estimate, {.what = "of the dissipated power at phase resonance"});
  v.record("chosen", s.chosen, {.what = "what the program has chosen for the accuracy, by key"});
}

/// Part of the target that the steps along the response may take.
constexpr double share_of_curve = 0.25;

/// The resonance that a drive holds up.
struct AtDrive {
  double amplitude = 0;  ///< [m]
  double gain = 1;       ///< [-]
};

/// Finds it on one span. Drive amplitudes in N or m; throws Interrupted.
class DriveSearch {
 public:
  explicit DriveSearch(const span::ShakenSpan& shaken) : shaken_(shaken) {}

  /// Begins at an amplitude [m]; nothing where none is found below the highest.
  std::optional<AtDrive> find(double drive, double begin, double highest) {
    constexpr int most_rounds = 16;
    constexpr double near = 0.02, step = 1.05, least_slope = 0.1;
    double amplitude = begin, slope = 1.5, before = 0, drive_before = 0;
    for (int round = 0; round < most_rounds && amplitude < highest; ++round) {
      const double now = drive_at(amplitude);
      if (std::isnan(now)) {  // between a solution and the next try
        if (before == 0) return std::nullopt;
        amplitude = std::sqrt(amplitude * before);
        continue;
      }
      if (now <= 0) {  // nothing is lost yet
        amplitude *= 2;
        continue;
      }
      if (std::abs(now / drive - 1) < near) {
        const double further = std::log(drive_at(step * amplitude) / now) / std::log(step);
        if (!(further > least_slope)) return std::nullopt;
        return AtDrive{.amplitude = amplitude, .gain = std::max(1.0, 1 / further)};
      }
      if (before > 0) slope = std::clamp(std::log(now / drive_before) / std::log(amplitude / before), 0.3, 8.0);
      before = amplitude;
      drive_before = now;
      amplitude *= std::clamp(std::pow(drive / now, 1 / slope), 0.2, 5.0);
    }
    return std::nullopt;
  }
  const section::Effort& effort() const { return effort_; }

 private:
  /// NaN where there is no resonance.
  double drive_at(double amplitude) {
    span::ResonanceAt found =
        last_ ? shaken_.resonance(amplitude, shaken_, last_->solution.state) : shaken_.resonance(amplitude);
    effort_ += found.effort;
    if (found.stopped) throw Interrupted("interrupted while the error was estimated");
    if (!found.solution.converged) return NAN;
    last_ = std::move(found);
    return last_->solution.state.drive;
  }

  const span::ShakenSpan& shaken_;
  std::optional<span::ResonanceAt> last_;
  section::Effort effort_;
};

class AccurateSweep final : public Analysis {
 public:
  explicit AccurateSweep(const Scene& asked) : asked_(asked), target_(*casefile::target_error(asked)) {
    ask_ = {.scene = asked, .keys = asked.as<casefile::SweepAnalysis>().periodic, .target = allowed()};
    ask_.scene.accuracy.reset();
    const build::BuiltSpan built = build::build_span(ask_.scene);
    drive_ = build::find_shaker(ask_.scene, built).size;
    setting_ = self_damping::first_periodic_setting(ask_);
    choose();  // refuses what has no drive, before its frequency is asked for
    ask_.frequency = drive_frequency(ask_.scene, built);
  }

  const Scene* base() const override { return &chosen_; }

  Outlook outlook() override {
    Outlook outlook = inner_->outlook();
    // A sweep has some eighty points; the estimate has twenty or so, most of them on half the mesh.
    constexpr double refined = 2.5;
    outlook.evaluations_most *= refined;
    outlook.modelled.merge(results::to_value(AccurateSweepSummary{.chosen = choice()}));
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    SweepError error = estimate(hooks, outcome);
    choose();
    inner_->run(hooks, outcome);
    finish(error, outcome.summary);
    outcome.tell(AccurateSweepSummary{.estimate = error, .chosen = choice()});
    if (outcome.exit_code == ExitCode::done && !(error.relative && *error.relative <= target_)) {
      outcome.warnings.push_back(words_of(error));
    }
  }

 private:
  double allowed() const { return (1 - share_of_curve) * target_; }
  bool swing_is_free() const { return !asked_.source.find("analysis.swing_step"); }
  /// At the crest a step of that part of the swing misses an eighth of its square at most.
  double swing_step() const {
    const double wanted = std::sqrt(8 * share_of_curve * target_);
    const double given = asked_.as<casefile::SweepAnalysis>().swing_step;
    return swing_is_free() ? std::min(given, wanted) : given;
  }

  void choose() {
    chosen_ = ask_.scene;
    chosen_.span->elements = setting_.elements;
    chosen_.section.points = setting_.points;
    auto& keys = std::get<casefile::SweepAnalysis>(chosen_.analysis);
    keys.periodic.harmonics = setting_.harmonics;
    keys.periodic.samples = setting_.samples;
    keys.swing_step = swing_step();
    inner_ = prepare(chosen_);
  }

  /// The parts at a resonance, and the setting that they are of.
  SweepError estimate(const Hooks& hooks, Outcome& outcome) {
    const auto tell = [&](const std::string& words) {
      if (hooks.progress) hooks.progress(0, "error estimate: " + words);
    };
    SweepError error{.target = target_};
    PeriodicSetting coarse = setting_;
    coarse.elements = std::max(1, setting_.elements / 2);
    tell("the amplitude that the drive holds up");
    const std::unique_ptr<span::ShakenSpan> shaken = self_damping::shaken_span_of(ask_, coarse, hooks.stop);
    const double diameter = build::section_numbers(ask_.scene).diameter;
    constexpr double begin = 0.1, highest = 5;  // diameters
    DriveSearch search(*shaken);
    const std::optional<AtDrive> at = search.find(drive_, begin * diameter, highest * diameter);
    section::Effort effort = search.effort();
    if (at) {
      ask_.antinode_amplitude = at->amplitude;
      ask_.target = allowed() / at->gain;
      const self_damping::PeriodicToTarget reached =
          self_damping::periodic_to_target(ask_, {.stop = hooks.stop, .tell = tell});
      effort += reached.effort;
      setting_ = reached.setting;
      const auto gained = [&](const std::optional<double>& part) {
        return part ? std::optional(at->gain * *part) : std::nullopt;
      };
      error.gain = at->gain;
      error.relative = gained(reached.error.relative);
      error.mesh = gained(reached.error.mesh);
      error.harmonics = gained(reached.error.harmonics);
      error.samples = gained(reached.error.samples);
      error.points = gained(reached.error.points);
    }
    error.section_evaluations = static_cast<double>(effort.evaluations);
    outcome.cost.section_evaluations += effort.evaluations;
    outcome.cost.section_sweeps += effort.sweeps;
    return error;
  }

  /// What the steps along the response have left.
  void finish(SweepError& error, const results::Value& summary) const {
    const std::optional<double> drive = casefile::number_at("backbone[-1].drive", summary);
    if (drive && error.gain) error.curve = *error.gain * std::abs(*drive / drive_ - 1);
    error.relative = error.relative && error.curve ? std::optional(*error.relative + *error.curve) : std::nullopt;
  }

  std::string words_of(const SweepError& error) const {
    if (!error.relative) {
      return "what the dissipated power is off by is not known: no resonance was found that the drive holds up, or a "
             "coarser span has none";
    }
    return fmt::format(
        "the dissipated power at resonance may be off by {:.2g} %, and {:.2g} % were asked for: mesh {:.2g}, harmonics "
        "{:.2g}, samples {:.2g}, points {:.2g}, steps along the response {:.2g} %",
        100 * *error.relative, 100 * target_, 100 * error.mesh.value_or(0), 100 * error.harmonics.value_or(0),
        100 * error.samples.value_or(0), 100 * error.points.value_or(0), 100 * error.curve.value_or(0));
  }

  SweepChoice choice() const {
    SweepChoice choice{.knobs = self_damping::choice_of(asked_, setting_)};
    if (swing_is_free()) choice.swing_step = swing_step();
    return choice;
  }

  const Scene& asked_;
  double target_;
  PeriodicAsk ask_;
  double drive_ = 0;  // [N] or [m]
  PeriodicSetting setting_;
  Scene chosen_;
  std::unique_ptr<Analysis> inner_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_accurate_sweep() {
  return results::ReferenceWriter::of<AccurateSweepSummary>();
}

std::unique_ptr<Analysis> prepare_accurate_sweep(const Scene& scene) {
  return std::make_unique<AccurateSweep>(scene);
}

}  // namespace strandyn::study
