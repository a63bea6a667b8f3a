#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "accurate_bench.hpp"
#include "entries.hpp"
#include "findings.hpp"
#include "march.hpp"
#include "outlook.hpp"
#include "self_damping_tables.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/self_damping/balance.hpp"
#include "strandyn/self_damping/compare.hpp"
#include "strandyn/self_damping/fit.hpp"
#include "strandyn/self_damping/grid_fit.hpp"
#include "strandyn/self_damping/log.hpp"
#include "study_accuracy.hpp"

namespace strandyn::study {

using casefile::DampingMethod;
using casefile::Scene;
using self_damping::Point;
using self_damping::PointLog;
using self_damping::PointRow;
using self_damping::Quadrature;

namespace {

struct RecomputedPoints {
  std::size_t points = 0;
};
template <class V>
void members(V& v, RecomputedPoints& r) {
  v.value("points", r.points, {.what = "whose lines of points.jsonl were not as they had been written"});
}

struct StudySummary {
  std::vector<PointRow> points;
  std::optional<StudyError> error{};
  self_damping::Fits fits;
  self_damping::GridFits grids;
  std::optional<std::vector<self_damping::OnsetRow>> onsets{};
  std::optional<std::vector<self_damping::ComparisonRow>> comparisons{};
  std::optional<std::vector<self_damping::BalanceRow>> balances{};
  std::optional<std::vector<self_damping::PlacementRow>> placements{};
  std::optional<std::vector<self_damping::DamageRow>> damages{};
  std::optional<RecomputedPoints> recomputed{};
};
template <class V>
void members(V& v, StudySummary& s) {
  v.record("error_estimate", s.error, {.what = "where `accuracy` is given: of the point that may be off by most"});
  v.list("points", s.points, {.what = "the points of the study"});
  v.part(s.fits);
  v.part(s.grids);
  v.list("no_slip_below", s.onsets, {.what = "amplitudes below which no contact slips"});
  v.list("comparisons", s.comparisons, {.what = "points that several methods have reached"});
  v.list("energy_balance", s.balances, {.what = "how far the conductor vibrates in the wind"});
  v.list("damper_placements", s.placements, {.what = "the first damper at the places that were tried"});
  v.list("damage", s.damages, {.what = "what a year of wind does to the conductor at its clamp"});
  v.record("recomputed", s.recomputed, {.what = "where a study has gone on: what was computed twice"});
}

/// What `describe` tells of a study.
struct StudyFacts {
  std::size_t points = 0;
  std::map<std::string, std::size_t> methods;
  std::vector<double> tensions;
  std::string mode_shape;
};
template <class V>
void members(V& v, StudyFacts& f) {
  v.value("points", f.points, {.what = "of the study"});
  for (const auto& [method, count] : f.methods)
    v.value(("points_" + method).c_str(), count, {.what = "by this method"});
  v.value("tensions_N", f.tensions, {.what = "of all points"});
  v.value("mode_shape", f.mode_shape, {.what = "that the quadrature goes over"});
}

bool needs_quadrature(const casefile::SelfDampingAnalysis& keys) {
  return keys.takes(DampingMethod::quadrature) ||
         std::ranges::any_of(keys.energy_balances, [](const casefile::EnergyBalanceKeys& balance) {
           return balance.self_damping == casefile::BalancedBy::quadrature;
         });
}

/// What a shard tells: its points, and nothing that speaks of all.
struct ShardSummary {
  std::vector<PointRow> points;
};
template <class V>
void members(V& v, ShardSummary& s) {
  v.list("points", s.points, {.what = "the points of the shard"});
}

class SelfDamping final : public Analysis, public Pieces {
 public:
  explicit SelfDamping(const Scene& scene) : scene_(scene), points_(self_damping::points_of(scene)) {
    const auto& keys = scene.as<casefile::SelfDampingAnalysis>();
    for (const Point& point : points_) make(point.method);
    if (needs_quadrature(keys)) make(DampingMethod::quadrature);
    for (const auto& [word, method] : methods_) expected_[word] = method->expected(points_by(word));
  }

  Outlook outlook() override {
    Outlook outlook;
    StudyFacts facts{.points = points_.size(),
                     .methods = {},
                     .tensions = self_damping::distinct_tensions(points_),
                     .mode_shape = std::string(name_of(scene_.as<casefile::SelfDampingAnalysis>().mode_shape))};
    for (const Point& point : points_) ++facts.methods[std::string(name_of(point.method))];
    outlook.tell("study", facts);
    tell_accuracy(outlook);
    const double tension = points_.front().tension;
    // Where whole spans vibrate, as much again for the harmonics or the steps.
    const SlippingCycle cycle{.axial_strain = tension / build::section_numbers(scene_).EA, .tangents = true};
    const double usual = 1.3 * slipping_time(*build::build_law(scene_, section::Dimension::planar), 16, cycle);
    double seconds = 0;
    for (const auto& [word, method] : methods_) {
      const self_damping::Expected own = method->expected_by_trial(points_by(word)).value_or(expected_.at(word));
      outlook.evaluations_least += own.least;
      outlook.evaluations_most += own.most;
      seconds += own.seconds > 0 ? own.seconds : usual * std::sqrt(own.least * own.most);
    }
    const double mean = std::sqrt(outlook.evaluations_least * outlook.evaluations_most);
    outlook.seconds_per_evaluation = mean > 0 ? seconds / mean : usual;
    outlook.memory = memory_in_use();
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override;

  const Pieces* pieces() const override { return this; }
  const char* noun() const override { return "point"; }
  std::size_t count() const override { return points_.size(); }
  std::vector<std::size_t> share(const Shard& shard) const override { return share_of(points_, shard); }
  std::string identity() const override { return self_damping::study_identity(scene_, section::vector_target().name); }
  Found look(const ShardFolder& shard) const override {
    const PointLog log = kept_in(shard.folder);
    Found found{.missing = {}, .fault = log.fault().value_or("")};
    for (const std::size_t i : share(shard.shard)) {
      if (!log.rows().contains(i)) found.missing.push_back(i);
    }
    return found;
  }
  void gather(const std::vector<ShardFolder>& shards, const std::filesystem::path& out) const override {
    PointLog all({.folder = out, .study = identity()}, points_);
    for (const ShardFolder& shard : shards) {
      const PointLog log = kept_in(shard.folder);
      for (const std::size_t i : share(shard.shard)) all.add(i, log.rows().at(i));
      for (const auto& [tension, table] : log.tables()) all.add(table);
    }
  }

 private:
  PointLog kept_in(const std::filesystem::path& folder) const {
    return PointLog({.folder = folder, .study = identity(), .resume = true, .read_only = true}, points_);
  }
  void make(DampingMethod word) {
    if (methods_.contains(word)) return;
    const bool by_bench = scene_.accuracy && word == DampingMethod::transient;
    methods_[word] = by_bench ? bench_to_target(scene_) : self_damping::make_method(word, scene_);
  }
  void tell_accuracy(Outlook& outlook) const {
    const std::optional<double> target = casefile::target_error(scene_);
    if (!target) return;
    AccuracyFacts facts{
        .target = *target,
        .chosen =
            "in the run: for each tension by quadrature, for each point by periodic and transient, refined "
            "until the estimated error is below the target"};
    for (const Point& point : points_) {
      if (point.method == DampingMethod::foti_2018) continue;
      auto& begun = point.method == DampingMethod::quadrature ? facts.quadrature
                    : point.method == DampingMethod::periodic ? facts.periodic
                                                              : facts.transient;
      if (!begun) begun = methods_.at(point.method)->first_choice(point);
    }
    outlook.tell("accuracy", facts);
  }
  std::vector<Point> points_by(DampingMethod word) const {
    if (word == DampingMethod::quadrature) return points_;  // it picks its own, and those of the balances
    std::vector<Point> own;
    std::ranges::copy_if(points_, std::back_inserter(own), [&](const Point& point) { return point.method == word; });
    return own;
  }
  /// How far the study came: what its points share is there; all points are.
  struct Reached {
    bool begun = false, finished = false;
  };
  void sum_up(const std::vector<PointRow>& rows, Reached reached, Outcome& outcome) const;

  const Scene& scene_;
  std::vector<Point> points_;
  Methods methods_;
  std::map<DampingMethod, self_damping::Expected> expected_;
};

void SelfDamping::run(const Hooks& hooks, Outcome& outcome) {
  PointLog log({.folder = hooks.folder, .study = identity(), .resume = hooks.resume}, points_);
  if (log.fault() && hooks.warn) hooks.warn(*log.fault());
  const std::vector<std::size_t> own = share(hooks.shard.value_or(Shard{}));
  const bool begun = March(scene_, hooks, methods_, points_, log).run(own);

  std::vector<PointRow> rows;
  std::size_t failed = 0;
  for (const std::size_t i : own) {
    const auto found = log.rows().find(i);
    if (found == log.rows().end()) continue;
    const PointRow& row = found->second;
    rows.push_back(row);
    failed += row.failed ? 1 : 0;
    // From the rows: a study that was interrupted counts like one that was not.
    outcome.cost.section_evaluations += row.section_evaluations.value_or(0);
    outcome.cost.section_sweeps += row.section_sweeps.value_or(0);
  }
  const bool finished = rows.size() == own.size();
  if (hooks.shard) {
    outcome.tell(ShardSummary{.points = rows});
    add_point_tables(scene_, rows, {}, outcome);
    for (const auto& [tension, table] : log.tables()) {
      outcome.cost.section_evaluations += table.evaluations;
      outcome.cost.section_sweeps += table.sweeps;
    }
  } else {
    sum_up(rows, {.begun = begun, .finished = finished}, outcome);
  }
  if (log.dropped() && !hooks.merged) {
    outcome.summary.set("recomputed", results::to_value(RecomputedPoints{.points = *log.dropped()}));
  }
  if (!finished) {
    outcome.exit_code = ExitCode::interrupted;
    outcome.message =
        fmt::format("stopped after {} of {} points; --resume goes on from there", rows.size(), own.size());
    return;
  }
  if (!hooks.shard) log.finish();  // a shard that is asked again has its points at once
  if (failed == 0) return;
  outcome.exit_code = ExitCode::not_converged;
  outcome.message = fmt::format("{} of {} points failed; each says why in its row", failed, own.size());
}

void SelfDamping::sum_up(const std::vector<PointRow>& rows, Reached reached, Outcome& outcome) const {
  StudySummary summary{
      .points = rows, .fits = self_damping::fit_points(scene_, rows), .grids = self_damping::fit_grids(scene_, rows)};
  summary.error = error_of(scene_, rows);
  if (summary.error) {
    if (const auto warning = warning_of(*summary.error, rows.size())) outcome.warnings.push_back(*warning);
  }
  if (summary.fits.warning) outcome.warnings.push_back(*summary.fits.warning);
  for (std::string& warning : self_damping::warnings_of_points(scene_, rows)) {
    outcome.warnings.push_back(std::move(warning));
  }
  for (const auto& [grid, name] :
       {std::pair{&summary.grids.by_velocity, "velocities"}, {&summary.grids.by_amplitude, "amplitudes"}}) {
    if (*grid && (*grid)->caveat) outcome.warnings.push_back(fmt::format("grid of {}: {}", name, *(*grid)->caveat));
  }
  const Quadrature* quadrature = nullptr;
  if (reached.begun && methods_.contains(DampingMethod::quadrature)) {
    quadrature = &dynamic_cast<const Quadrature&>(*methods_.at(DampingMethod::quadrature));
    auto onsets = self_damping::onsets_of(scene_, *quadrature, points_);
    if (!onsets.empty()) summary.onsets = std::move(onsets);
    self_damping::Comparison comparison = self_damping::compare_methods(*quadrature, rows);
    if (!comparison.rows.empty()) summary.comparisons = std::move(comparison.rows);
    if (comparison.warning) outcome.warnings.push_back(*comparison.warning);
  }
  if (reached.finished && !scene_.as<casefile::SelfDampingAnalysis>().energy_balances.empty()) {
    self_damping::Balances balances = self_damping::energy_balances(
        {.scene = scene_, .points = points_, .quadrature = quadrature, .fit = summary.fits.law});
    for (std::string& warning : balances.warnings) outcome.warnings.push_back(std::move(warning));
    summary.balances = std::move(balances.rows);
    if (!balances.placements.empty()) summary.placements = std::move(balances.placements);
    if (!balances.damages.empty()) summary.damages = std::move(balances.damages);
  }
  outcome.tell(summary);
  outcome.findings = findings_of(summary.fits, summary.grids);
  std::ranges::move(findings_of_bench(rows), std::back_inserter(outcome.findings));
  if (summary.balances) std::ranges::move(findings_of(*summary.balances), std::back_inserter(outcome.findings));
  add_point_tables(scene_, rows, summary.fits.law, outcome);
  add_local_exponents(scene_, rows, outcome);
  add_readings(rows, outcome);
  if (quadrature) add_loss_table(*quadrature, outcome);
  if (summary.balances) add_balances(*summary.balances, outcome);
}

}  // namespace

std::vector<results::MemberNote> notes_of_self_damping() {
  return results::ReferenceWriter::of<StudySummary>();
}

std::unique_ptr<Analysis> prepare_self_damping(const Scene& scene) {
  return std::make_unique<SelfDamping>(scene);
}

}  // namespace strandyn::study
