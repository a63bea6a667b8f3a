#include "sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "entries.hpp"
#include "findings.hpp"
#include "outlook.hpp"
#include "strandyn/span/shaken_span.hpp"

namespace strandyn::study {

using casefile::Scene;
using solver::PeriodicSolution;
using std::numbers::pi;

namespace {

/// The columns of sweep.csv and the members of `sweep`.
struct SweepRow {
  double frequency = 0, antinode_amplitude = 0, phase = 0;
  double dissipated_power = 0, friction = 0, material = 0, viscous = 0, air = 0, drive_power = 0;
};
template <class V>
void members(V& v, SweepRow& r) {
  v.value("frequency_Hz", r.frequency, {.what = "of the drive"});
  v.value("antinode_amplitude_m", r.antinode_amplitude, {.what = "half of peak to peak at the antinode"});
  v.value("phase_deg", r.phase, {.what = "by which the driven point follows the force"});
  v.value("dissipated_power_W", r.dissipated_power, {.what = "friction, material and viscous damping"});
  v.value("friction_W", r.friction, {.what = "by the loops of all sections"});
  v.value("material_W", r.material, {.what = "by the metal of the wires"});
  v.value("viscous_W", r.viscous, {.what = "by viscous forces"});
  v.value("air_W", r.air, {.what = "by still air, not in the dissipated power"});
  v.value("drive_power_W", r.drive_power, {.what = "of the drive"});
}

/// A place on the response: its highest point, or where it is in phase resonance.
struct CrestRow {
  double frequency = 0, antinode_amplitude = 0, dissipated_power = 0;
  std::optional<bool> inside{};
};
template <class V>
void members(V& v, CrestRow& c) {
  v.value("frequency_Hz", c.frequency, {.what = "of the drive", .shown = "resonance"});
  v.value("antinode_amplitude_m", c.antinode_amplitude, {.what = "there", .shown = "antinode amplitude"});
  v.value("dissipated_power_W", c.dissipated_power, {.what = "there", .shown = "dissipated power"});
  v.value("inside", c.inside, {.what = "whether it lies inside the sweep"});
}

/// The columns of backbone.csv and the members of `backbone`.
struct BackboneRow {
  double antinode_amplitude = 0, frequency = 0, frequency_shift = 0, drive = 0, dissipated_power = 0, mean_tension = 0;
};
template <class V>
void members(V& v, BackboneRow& b) {
  v.value("antinode_amplitude_m", b.antinode_amplitude, {.what = "that was asked for"});
  v.value("frequency_Hz", b.frequency, {.what = "of phase resonance there"});
  v.value("frequency_shift", b.frequency_shift, {.what = "relative to the mode with all wires sticking"});
  v.value("drive", b.drive, {.what = "that it takes, N or m"});
  v.value("dissipated_power_W", b.dissipated_power, {.what = "friction, material and viscous damping"});
  v.value("mean_tension_N", b.mean_tension, {.what = "over a cycle"});
}

struct SweepSummary {
  int mode = 0;
  double linear_frequency = 0;
  std::optional<double> drive_force{}, drive_motion{};
  std::vector<SweepRow> sweep{};
  std::optional<CrestRow> peak{}, resonance{};
  std::optional<std::vector<BackboneRow>> backbone{};
};
template <class V>
void members(V& v, SweepSummary& s) {
  v.value("mode", s.mode, {.what = "that the sweep goes through"});
  v.value("linear_frequency_Hz", s.linear_frequency, {.what = "of the mode with all wires sticking"});
  v.value("drive_force_N", s.drive_force, {.what = "amplitude of the force"});
  v.value("drive_motion_m", s.drive_motion, {.what = "amplitude of the motion"});
  v.list("sweep", s.sweep, {.what = "the response, point by point"});
  v.record("peak", s.peak, {.what = "the highest point"});
  v.record("resonance", s.resonance, {.what = "where the response is a quarter of a cycle behind the drive"});
  v.list("backbone", s.backbone, {.what = "phase resonances up to the amplitude that the drive reaches"});
}

/// The highest point: steps of a tenth of the response miss the crest by about its thousandth.
CrestRow peak_of(const std::vector<SweepRow>& sweep) {
  const auto top = std::ranges::max_element(sweep, {}, &SweepRow::antinode_amplitude);
  return {.frequency = top->frequency,
          .antinode_amplitude = top->antinode_amplitude,
          .dissipated_power = top->dissipated_power,
          .inside = top != sweep.begin() && top + 1 != sweep.end()};
}

/// Between the points on the two sides of a quarter of a cycle; the peak where the sweep does not come across it.
CrestRow resonance_of(const std::vector<SweepRow>& sweep, const CrestRow& peak) {
  for (std::size_t i = 1; i < sweep.size(); ++i) {
    const double before = sweep[i - 1].phase - 90;
    const double after = sweep[i].phase - 90;
    if (before * after > 0 || std::abs(before - after) > 90) continue;
    const auto between = [&](double SweepRow::*member) {
      const double from = sweep[i - 1].*member, to = sweep[i].*member;
      return before == after ? from : from + (to - from) * before / (before - after);
    };
    return {.frequency = between(&SweepRow::frequency),
            .antinode_amplitude = between(&SweepRow::antinode_amplitude),
            .dissipated_power = between(&SweepRow::dissipated_power)};
  }
  return {.frequency = peak.frequency,
          .antinode_amplitude = peak.antinode_amplitude,
          .dissipated_power = peak.dissipated_power};
}

class Sweep final : public Analysis {
 public:
  explicit Sweep(const Scene& scene)
      : scene_(scene),
        keys_(scene.as<casefile::SweepAnalysis>()),
        built_(build::build_span(scene)),
        shaker_(build::find_shaker(scene, built_)) {
    if (shaker_.size == 0) {
      const build::ShakerKey key = build::shaker_of(scene);
      refuse(scene.source,
             key.load ? fmt::format("load[{}].amplitude_N", *key.load)
                      : fmt::format("motion[{}].amplitude_mm", *key.motion),
             "nothing drives the sweep", "give an amplitude above 0");
    }
    check_plan(scene, built_, {});
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    const span::SpanAtRest span(built_);
    // Some eighty points and the backbone; once to ten times around the loops for each, derivatives for some. Compiled
    // otherwise, Newton's method may take three times as many rounds around a fold.
    const double once = static_cast<double>(built_.section_points()) * keys_.periodic.samples * 4;
    expect(outlook, once * (40 + keys_.backbone_points) * 34, 3.1);
    // The harmonics of the whole span are solved beside: more than the law takes on a short one.
    const SlippingCycle cycle{.axial_strain = built_.tension / built_.numbers.EA, .tangents = true};
    outlook.seconds_per_evaluation =
        evaluation_time(span) + 2.2 * slipping_time(*built_.model.law, built_.section_points(), cycle);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    const span::ShakenSpan shaken(
        built_, shaker_, drive_frequency(scene_, built_),
        {.harmonics = keys_.periodic.harmonics, .samples = keys_.periodic.samples, .stop = hooks.stop});
    SweepSummary summary{.mode = shaken.mode_number(), .linear_frequency = shaken.mode().frequency};
    (shaker_.moves ? summary.drive_motion : summary.drive_force) = shaker_.size;
    bool stopped = false;
    const auto stop = [&] { return stopped = stopped || (hooks.stop && hooks.stop()); };
    sweep(shaken, hooks, stop, summary, outcome);
    if (!summary.sweep.empty()) {
      summary.peak = peak_of(summary.sweep);
      summary.resonance = resonance_of(summary.sweep, *summary.peak);
    }
    if (!stopped && outcome.exit_code == ExitCode::done) backbone(shaken, hooks, stop, summary, outcome);
    outcome.tell(summary);
    if (summary.resonance) {
      outcome.findings.push_back(fmt::format(
          "Phase resonance at {:.5g} Hz, {:+.3g} % from where the mode of sticking wires lies, with an antinode "
          "amplitude "
          "of {} and {} lost.",
          summary.resonance->frequency, 100 * (summary.resonance->frequency / summary.linear_frequency - 1),
          amount(summary.resonance->antinode_amplitude, "m"), amount(summary.resonance->dissipated_power, "W")));
    }
    add_tables(summary, outcome);
    if (!stopped) return;
    outcome.exit_code = ExitCode::interrupted;
    outcome.message = fmt::format("interrupted after {} points of the sweep; they are kept", summary.sweep.size());
  }

 private:
  void sweep(const span::ShakenSpan& shaken, const Hooks& hooks, const Stop& stop, SweepSummary& summary,
             Outcome& outcome) const {
    const double linear = shaken.mode().frequency;
    const double from = keys_.from.value_or(linear * (1 - keys_.relative_width));
    const double to = keys_.to.value_or(linear * (1 + keys_.relative_width));
    constexpr double parts = 40;
    const auto hear = [&](const PeriodicSolution& s) {
      add(s.effort, outcome);
      const double frequency = s.state.frequency;
      summary.sweep.push_back({.frequency = frequency,
                               .antinode_amplitude = shaken.antinode_amplitude(s.state),
                               .phase = 180 / pi * shaken.phase(s.state),
                               .dissipated_power = span::losses_of(s) * frequency,
                               .friction = span::friction_of(s) * frequency,
                               .material = s.material * frequency,
                               .viscous = s.viscous.total() * frequency,
                               .air = s.air * frequency,
                               .drive_power = s.drive_power});
      if (hooks.progress) {
        hooks.progress(
            0.8 * std::clamp((frequency - from) / (to - from), 0.0, 1.0),
            fmt::format("{:.4f} Hz, antinode {:.3g} mm", frequency, 1e3 * summary.sweep.back().antinode_amplitude));
      }
      return !stop();
    };
    try {
      const auto solutions =
          shaken.solver().sweep({.from = from,
                                 .to = to,
                                 .drive = shaker_.size,
                                 .frequency_step = keys_.frequency_step.value_or(std::abs(to - from) / parts),
                                 .swing_step = keys_.swing_step,
                                 .each = hear});
      if (solutions.back().converged) return;
      outcome.exit_code = ExitCode::not_converged;
      outcome.message = solutions.back().failure;
    } catch (const Interrupted&) {
      stop();  // notes it: the points that were heard of are kept
    }
  }

  /// Resonances at equal parts of the amplitude that the drive reaches: the last one is that by another method.
  void backbone(const span::ShakenSpan& shaken, const Hooks& hooks, const Stop& stop, SweepSummary& summary,
                Outcome& outcome) const {
    std::vector<BackboneRow>& rows = summary.backbone.emplace();
    const double top = summary.resonance->antinode_amplitude;
    for (int i = 1; i <= keys_.backbone_points && !stop(); ++i) {
      const span::ResonanceAt found = shaken.resonance(top * i / keys_.backbone_points);
      add(found.effort, outcome);
      if (found.stopped) break;
      const PeriodicSolution& s = found.solution;
      if (!s.converged) {
        outcome.exit_code = ExitCode::not_converged;
        outcome.message = s.failure;
        break;
      }
      rows.push_back({.antinode_amplitude = found.antinode_amplitude,
                      .frequency = s.state.frequency,
                      .frequency_shift = s.state.frequency / shaken.mode().frequency - 1,
                      .drive = s.state.drive,
                      .dissipated_power = span::losses_of(s) * s.state.frequency,
                      .mean_tension = shaken.strains(s.state).mean_tension});
      if (hooks.progress) {
        hooks.progress(0.8 + 0.2 * i / keys_.backbone_points,
                       fmt::format("resonance {} of {}", i, keys_.backbone_points));
      }
    }
  }

  static void add(const section::Effort& effort, Outcome& outcome) {
    outcome.cost.section_evaluations += effort.evaluations;
    outcome.cost.section_sweeps += effort.sweeps;
  }

  static void add_tables(const SweepSummary& summary, Outcome& outcome) {
    if (summary.sweep.empty()) return;
    outcome.tables.push_back({.file = "sweep.csv", .table = results::table_of(summary.sweep)});
    outcome.figures.push_back({.name = "response",
                               .title = "Steady response",
                               .table = "sweep.csv",
                               .x = "frequency_Hz",
                               .y = {"antinode_amplitude_m"},
                               .caption = "Antinode amplitude at the given drive, through the resonance."});
    outcome.figures.push_back(
        {.name = "phase",
         .title = "Phase",
         .table = "sweep.csv",
         .x = "frequency_Hz",
         .y = {"phase_deg"},
         .caption = "How far the driven point follows the force; 90 degrees at phase resonance."});
    outcome.shown.push_back({.title = "Response",
                             .table = "sweep.csv",
                             .columns = {"frequency_Hz", "antinode_amplitude_m", "phase_deg", "dissipated_power_W"}});
    if (!summary.backbone || summary.backbone->empty()) return;
    outcome.tables.push_back({.file = "backbone.csv", .table = results::table_of(*summary.backbone)});
    outcome.figures.push_back({.name = "backbone",
                               .title = "Resonances by amplitude",
                               .table = "backbone.csv",
                               .x = "frequency_Hz",
                               .y = {"antinode_amplitude_m"},
                               .caption = "Phase resonance at rising amplitude: slipping wires make the span softer."});
  }

  const Scene& scene_;
  const casefile::SweepAnalysis& keys_;
  build::BuiltSpan built_;
  build::Shaker shaker_;
};

}  // namespace

double drive_frequency(const Scene& scene, const build::BuiltSpan& built) {
  const auto named = [&](const auto& drive) {
    if (!drive.frequency_mode) return *drive.frequency;
    const span::SpanAtRest span(built);
    return span::modes_across(span, *drive.frequency_mode).back().frequency;
  };
  const build::ShakerKey key = build::shaker_of(scene);
  return key.load ? named(scene.loads[*key.load]) : named(scene.motions[*key.motion]);
}

std::vector<results::MemberNote> notes_of_sweep() {
  return results::ReferenceWriter::of<SweepSummary>();
}

std::unique_ptr<Analysis> prepare_sweep(const Scene& scene) {
  return std::make_unique<Sweep>(scene);
}

}  // namespace strandyn::study
