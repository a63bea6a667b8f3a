#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "entries.hpp"
#include "findings.hpp"
#include "strandyn/build/clamp.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/fatigue/rainflow.hpp"

namespace strandyn::study {

using casefile::FatigueAnalysis;
using casefile::Scene;

namespace {

constexpr double micrometre = 1e-6, hour = 3600, hours_a_year = 8766;

/// So many cycles of a bending amplitude, peak to peak. [m]
struct Recorded {
  double bending_amplitude = 0, cycles = 0;
};

struct FatigueSummary {
  double tension = 0, recorded_hours = 0, cycles = 0;
  double largest_amplitude = 0, largest_stress = 0;
  double damage = 0, damage_a_year = 0;
  std::optional<double> years{};
  double cycles_above_limit = 0;
};
template <class V>
void members(V& v, FatigueSummary& s) {
  v.value("tension_N", s.tension, {.what = "the tension"});
  v.value("recorded_hours", s.recorded_hours, {.what = "that the record stands for"});
  v.value("cycles", s.cycles, {.what = "of the record"});
  v.value("largest_bending_amplitude_m", s.largest_amplitude,
          {.what = "peak to peak", .shown = "largest bending amplitude"});
  v.value("largest_stress_Pa", s.largest_stress,
          {.what = "amplitude in a surface wire, Poffenberger and Swart", .shown = "largest stress"});
  v.value("cycles_above_endurance_limit", s.cycles_above_limit,
          {.what = "whose stress is above EPRI's endurance limit of ACSR with several layers of aluminium, 8.5 MPa, or "
                   "with one, 22.5 MPa"});
  v.value("damage", s.damage, {.what = "Miner's sum of the record over CIGRE's safe border line"});
  v.value("damage_per_year", s.damage_a_year, {.what = "if the year goes on like this", .shown = "damage per year"});
  v.value("years", s.years, {.what = "until it is 1", .shown = "years of life"});
}

class Fatigue final : public Analysis {
 public:
  explicit Fatigue(const Scene& scene) : scene_(scene), keys_(scene.as<FatigueAnalysis>()) {
    if (keys_.tension_rts && scene.conductor->strand.rated_strength == 0) {
      refuse(scene.source, "analysis.tension_rts", "the rated strength of the conductor is not known",
             "give tension_kN, or conductor.rated_strength_kN");
    }
    tension_ = keys_.tension ? *keys_.tension : *keys_.tension_rts * scene.conductor->strand.rated_strength;
    if (keys_.matrix_file) {
      read_matrix();
    } else {
      read_history();
    }
  }

  Outlook outlook() override { return {}; }  // a sum

  void run(const Hooks&, Outcome& outcome) override {
    const conductor::Strand& strand = scene_.conductor->strand;
    const analysis::SurfaceWire surface = build::surface_wire(strand);
    const fatigue::AluminiumLayers layers = build::aluminium_layers(strand);
    const double limit = fatigue::endurance_limit(layers);
    const analysis::ClampedEnd end{
        .tension = tension_, .EI_min = build::section_numbers(scene_).EI_min, .distance = keys_.distance};
    FatigueSummary summary{.tension = tension_, .recorded_hours = hours_};
    results::Table table({"bending_amplitude_m", "stress_Pa", "cycles", "cycles_endured", "damage"});
    for (const Recorded& row : recorded_) {
      const double stress = analysis::bending_stress(end, surface, row.bending_amplitude);
      const double endured = fatigue::cycles_endured(layers, stress);
      const double damage = row.cycles / endured;
      summary.cycles += row.cycles;
      summary.damage += damage;
      summary.largest_amplitude = std::max(summary.largest_amplitude, row.bending_amplitude);
      summary.largest_stress = std::max(summary.largest_stress, stress);
      if (stress > limit) summary.cycles_above_limit += row.cycles;
      if (stress > 0) table.append(std::array{row.bending_amplitude, stress, row.cycles, endured, damage});
    }
    summary.damage_a_year = summary.damage * hours_a_year / hours_;
    if (summary.damage > 0) summary.years = 1 / summary.damage_a_year;
    outcome.tell(summary);
    outcome.findings.push_back(fmt::format(
        "{:.3g} cycles in {:.3g} hours, up to {} peak to peak and a Poffenberger-Swart stress of {}: {}.",
        summary.cycles, hours_, amount(summary.largest_amplitude, "m"), amount(summary.largest_stress, "Pa"),
        summary.years
            ? fmt::format("if every hour is like these, the damage sum of CIGRE's safe border line is 1 after "
                          "{:.3g} years",
                          *summary.years)
            : "no damage by CIGRE's safe border line"));
    outcome.tables.push_back({.file = "spectrum.csv", .table = std::move(table)});
    outcome.figures.push_back({.name = "spectrum",
                               .title = "Where the damage comes from",
                               .table = "spectrum.csv",
                               .x = "bending_amplitude_m",
                               .y = {"damage"},
                               .y_scale = "log",
                               .caption = "Damage of the record by bending amplitude, peak to peak: cycles over those "
                                          "that CIGRE's safe border line endures."});
    outcome.warnings.emplace_back(
        "a record of some days is no year: damage grows with the fifth to sixth power of the amplitude, so the few "
        "strongest hours decide");
  }

 private:
  results::Table read(const std::string& file, const char* key, const std::vector<std::string>& columns) const {
    results::Table table = results::read_csv(std::filesystem::path(scene_.source.file).parent_path() / file);
    for (const std::string& column : columns) {
      if (table.has(column)) continue;
      refuse(scene_.source, key, fmt::format("the file has the columns {}", fmt::join(table.names(), ", ")),
             fmt::format("give the columns {}", fmt::join(columns, ", ")));
    }
    return table;
  }

  void read_matrix() {
    const results::Table table =
        read(*keys_.matrix_file, "analysis.matrix_file", {"bending_amplitude_um", "frequency_Hz", "cycles"});
    const auto& amplitude = table.column("bending_amplitude_um");
    const auto& cycles = table.column("cycles");
    const auto& frequency = table.column("frequency_Hz");
    double seconds = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (amplitude[i] < 0 || cycles[i] < 0 || frequency[i] <= 0) {
        refuse(scene_.source, "analysis.matrix_file",
               fmt::format("row {}: amplitudes and cycles are not below 0, frequencies above", i + 1), "mend the file");
      }
      recorded_.push_back({.bending_amplitude = micrometre * amplitude[i], .cycles = cycles[i]});
      seconds += cycles[i] / frequency[i];
    }
    if (!keys_.recorded) {
      refuse(scene_.source, "analysis.recorded_hours", "is missing, and a matrix does not say for how long it stands",
             "give the hours, gaps between recordings included");
    }
    hours_ = *keys_.recorded;
    if (seconds <= 1.001 * hour * hours_) return;
    refuse(scene_.source, "analysis.recorded_hours",
           fmt::format("the cycles of the matrix take {:.4g} h by themselves", seconds / hour),
           "give the time that the matrix stands for");
  }

  void read_history() {
    if (keys_.recorded) {
      refuse(scene_.source, "analysis.recorded_hours", "belongs to a matrix; a history has its own time",
             "leave it out");
    }
    const results::Table table = read(*keys_.history_file, "analysis.history_file", {"time_s", "deflection_um"});
    const auto& time = table.column("time_s");
    if (time.size() < 2 || std::ranges::adjacent_find(time, std::ranges::greater_equal{}) != time.end()) {
      refuse(scene_.source, "analysis.history_file", "its times do not rise", "give two rows and more of rising time");
    }
    for (const fatigue::CountedCycle& cycle : fatigue::rainflow(table.column("deflection_um"))) {
      recorded_.push_back({.bending_amplitude = micrometre * cycle.range, .cycles = cycle.count});
    }
    hours_ = (time.back() - time.front()) / hour;
  }

  const Scene& scene_;
  const FatigueAnalysis& keys_;
  double tension_ = 0, hours_ = 0;
  std::vector<Recorded> recorded_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_fatigue() {
  return results::ReferenceWriter::of<FatigueSummary>();
}

std::unique_ptr<Analysis> prepare_fatigue(const Scene& scene) {
  return std::make_unique<Fatigue>(scene);
}

}  // namespace strandyn::study
