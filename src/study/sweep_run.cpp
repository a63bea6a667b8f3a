#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "shaken_span.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;
using solver::PeriodicSolution;
using std::numbers::pi;

namespace {

/// [Hz] that the drive names, and its size: [N] or [m].
struct DriveOfScene {
  double frequency = 0;
  double size = 0;
};

DriveOfScene drive_of(const Scene& scene) {
  const Shaker shaker = shaker_of(scene);
  const auto read = [&](const auto& drive) -> DriveOfScene {
    double frequency = drive.frequency.value_or(0);
    if (drive.frequency_mode) {
      const SpanAtRest span(scene);
      const auto count = static_cast<std::size_t>(*drive.frequency_mode);
      frequency = solver::transverse_modes(span.system, span.u, count).back().frequency;
    }
    return {.frequency = frequency, .size = std::abs(drive.value())};
  };
  return shaker.load ? read(scene.loads[*shaker.load]) : read(scene.motions[*shaker.motion]);
}

/// The columns of sweep.csv and the keys of `sweep`.
json point_json(const ShakenSpan& shaken, const PeriodicSolution& s) {
  const double frequency = s.state.frequency;
  return {{"frequency_Hz", frequency},
          {"antinode_amplitude_m", shaken.antinode_amplitude(s.state)},
          {"phase_deg", 180 / pi * shaken.phase(s.state)},
          {"dissipated_power_W", losses_of(s) * frequency},
          {"friction_W", friction_of(s) * frequency},
          {"viscous_W", s.viscous.total() * frequency},
          {"drive_power_W", s.drive_power}};
}

void add_table(const char* file, const json& rows, CaseResult& result) {
  if (rows.empty()) return;
  std::vector<std::string> names;
  for (const auto& [key, value] : rows.front().items()) names.push_back(key);
  results::Table table(names);
  for (const json& row : rows) {
    std::vector<double> values;
    for (const auto& [key, value] : row.items()) values.push_back(value);
    table.append(values);
  }
  result.tables.push_back({file, std::move(table)});
}

/// The highest point: steps of a tenth of the response miss the crest by about its thousandth.
json peak_of(const json& sweep) {
  std::size_t top = 0;
  const auto amplitude = [&](std::size_t i) -> double { return sweep[i]["antinode_amplitude_m"]; };
  const auto frequency = [&](std::size_t i) -> double { return sweep[i]["frequency_Hz"]; };
  for (std::size_t i = 1; i < sweep.size(); ++i) top = amplitude(i) > amplitude(top) ? i : top;
  return {{"frequency_Hz", frequency(top)},
          {"antinode_amplitude_m", amplitude(top)},
          {"dissipated_power_W", sweep[top]["dissipated_power_W"]},
          {"inside", top > 0 && top + 1 < sweep.size()}};
}

/// Where the response follows the drive by a quarter of a cycle, between the points on the two sides of it; the peak
/// where the sweep does not come across it.
json resonance_of(const json& sweep, const json& peak) {
  for (std::size_t i = 1; i < sweep.size(); ++i) {
    const double before = sweep[i - 1]["phase_deg"].get<double>() - 90;
    const double after = sweep[i]["phase_deg"].get<double>() - 90;
    if (before * after > 0 || std::abs(before - after) > 90) continue;
    const auto between = [&](const char* key) {
      const double from = sweep[i - 1][key], to = sweep[i][key];
      return before == after ? from : from + (to - from) * before / (before - after);
    };
    return {{"frequency_Hz", between("frequency_Hz")},
            {"antinode_amplitude_m", between("antinode_amplitude_m")},
            {"dissipated_power_W", between("dissipated_power_W")}};
  }
  return {{"frequency_Hz", peak["frequency_Hz"]},
          {"antinode_amplitude_m", peak["antinode_amplitude_m"]},
          {"dissipated_power_W", peak["dissipated_power_W"]}};
}

class SweepRun {
 public:
  SweepRun(const Scene& scene, const Hooks& hooks, CaseResult& result)
      : keys_(scene.analysis.sweep),
        hooks_(hooks),
        result_(result),
        drive_(drive_of(scene)),
        shaken_(scene, drive_.frequency, keys_.periodic) {}

  void run() {
    json& s = result_.summary;
    s["mode"] = shaken_.mode_number();
    s["linear_frequency_Hz"] = shaken_.mode().frequency;
    s[shaken_.drive_kind() == solver::DriveKind::force ? "drive_force_N" : "drive_motion_m"] = drive_.size;
    s["sweep"] = json::array();
    sweep();
    add_table("sweep.csv", s["sweep"], result_);
    if (!s["sweep"].empty()) {
      s["peak"] = peak_of(s["sweep"]);
      s["resonance"] = resonance_of(s["sweep"], s["peak"]);
    }
    if (!stopped_ && result_.exit_code == ExitCode::done) backbone();
    s["cost"]["section_evaluations"] = effort_.evaluations;
    s["cost"]["section_sweeps"] = effort_.sweeps;
    if (!stopped_) return;
    result_.exit_code = ExitCode::interrupted;
    result_.message = fmt::format("interrupted after {} points of the sweep; they are kept", s["sweep"].size());
  }

 private:
  bool stop() {
    stopped_ = stopped_ || (hooks_.stop && hooks_.stop());
    return stopped_;
  }

  void sweep() {
    const double linear = shaken_.mode().frequency;
    const double from = keys_.from.value_or(linear * (1 - keys_.relative_width));
    const double to = keys_.to.value_or(linear * (1 + keys_.relative_width));
    constexpr double parts = 40;
    const auto hear = [&](const PeriodicSolution& solution) {
      effort_ += solution.effort;
      result_.summary["sweep"].push_back(point_json(shaken_, solution));
      if (hooks_.progress) {
        const double frequency = solution.state.frequency;
        hooks_.progress(0.8 * std::clamp((frequency - from) / (to - from), 0.0, 1.0),
                        fmt::format("{:.4f} Hz, antinode {:.3g} mm", frequency,
                                    1e3 * result_.summary["sweep"].back()["antinode_amplitude_m"].get<double>()));
      }
      return !stop();
    };
    const auto solutions =
        shaken_.solver().sweep({.from = from,
                                .to = to,
                                .drive = drive_.size,
                                .frequency_step = keys_.frequency_step.value_or(std::abs(to - from) / parts),
                                .swing_step = keys_.swing_step,
                                .each = hear});
    if (solutions.back().converged) return;
    result_.exit_code = ExitCode::not_converged;
    result_.message = solutions.back().failure;
  }

  /// Resonances at equal parts of the amplitude that the drive reaches: the last one is that by another road.
  void backbone() {
    json& list = result_.summary["backbone"] = json::array();
    const double top = result_.summary["resonance"]["antinode_amplitude_m"];
    for (int i = 1; i <= keys_.backbone_points && !stop(); ++i) {
      const ResonanceAt found = shaken_.resonance(top * i / keys_.backbone_points, [this] { return stop(); });
      effort_ += found.effort;
      if (found.stopped) break;
      const PeriodicSolution& s = found.solution;
      if (!s.converged) {
        result_.exit_code = ExitCode::not_converged;
        result_.message = s.failure;
        break;
      }
      list.push_back({{"antinode_amplitude_m", found.antinode_amplitude},
                      {"frequency_Hz", s.state.frequency},
                      {"frequency_shift", s.state.frequency / shaken_.mode().frequency - 1},
                      {"drive", s.state.drive},
                      {"dissipated_power_W", losses_of(s) * s.state.frequency},
                      {"mean_tension_N", shaken_.strains(s.state).mean_tension}});
      if (hooks_.progress) {
        hooks_.progress(0.8 + 0.2 * i / keys_.backbone_points,
                        fmt::format("resonance {} of {}", i, keys_.backbone_points));
      }
    }
    add_table("backbone.csv", list, result_);
  }

  const casefile::SweepAnalysis& keys_;
  const Hooks& hooks_;
  CaseResult& result_;
  DriveOfScene drive_;
  ShakenSpan shaken_;
  section::Effort effort_ = {};
  bool stopped_ = false;
};

}  // namespace

void run_sweep(const Scene& scene, const Hooks& hooks, CaseResult& result) {
  SweepRun(scene, hooks, result).run();
}

}  // namespace strandyn::study
