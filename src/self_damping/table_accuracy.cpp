#include "table_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numbers>

#include "strandyn/analysis/richardson.hpp"
#include "strandyn/build/section_law.hpp"

namespace strandyn::self_damping {

using casefile::Scene;

namespace {

constexpr int most_rounds = 12, most_tables = 3;
constexpr int most_finer = 8;  ///< times the steps begun with

/// What a table hangs on.
struct Setting {
  int steps = 0, knots = 0, points = 0;
  double tolerance = 0;
};

/// Sections alone may have more points than those of spans.
std::optional<int> finer_points(int points) {
  constexpr int most = 144;
  const std::optional<int> finer = build::finer_points(points);
  return finer || points >= most ? finer : std::optional(most);
}

/// The next multiple of eight: a quarter of the steps are run, too, in an even number.
int eightfold(double steps) {
  return 8 * static_cast<int>(std::ceil(steps / 8));
}

/// The knobs that the case leaves open.
struct Free {
  explicit Free(const Scene& scene)
      : steps(!scene.source.find("analysis.quadrature.steps")),
        knots(!scene.source.find("analysis.quadrature.knots_per_decade")),
        tolerance(!scene.source.find("analysis.quadrature.tolerance")),
        points(!scene.source.find("section.points") && build::slips_by_points(scene.section.law)) {}
  bool steps, knots, tolerance, points;
};

Setting first_setting(const Scene& scene, double target) {
  const Free free(scene);
  const casefile::QuadratureKeys& keys = scene.as<casefile::SelfDampingAnalysis>().quadrature;
  Setting setting{
      .steps = keys.steps, .knots = keys.knots_per_decade, .points = scene.section.points, .tolerance = keys.tolerance};
  // The steps alone leave 2/s^2.
  if (free.steps) setting.steps = eightfold(2.1 / std::sqrt(target));
  if (free.knots) setting.knots = static_cast<int>(std::ceil(3 / std::pow(target, 0.27)));
  if (free.tolerance) setting.tolerance = target / 4;
  if (free.points) setting.points = target >= 0.05 ? 20 : 36;
  return setting;
}

PointChoice choice_of(const Setting& setting, const Free& free) {
  PointChoice choice;
  if (free.steps) choice.steps = setting.steps;
  if (free.knots) choice.knots_per_decade = setting.knots;
  if (free.tolerance) choice.tolerance = setting.tolerance;
  if (free.points) choice.points = setting.points;
  return choice;
}

/// Part of all that is allowed that the table may take, so that steps and points are settled before it is made.
constexpr double share_of_table = 0.25;
/// The table is compared at a few places of a sine only, and points by one difference.
constexpr double by_table_alone = 1.5, by_points_alone = 1.5;

class Tuning {
 public:
  explicit Tuning(const TableAsk& ask)
      : ask_(ask),
        free_(ask.scene),
        slips_(build::slips_by_points(ask.scene.section.law)),
        first_(first_setting(ask.scene, ask.target)),
        setting_(first_) {
    for (const Probe& probe : ask.probes) {
      for (int i = 0; i < places; ++i) {
        const double t = (i + 0.5) / places;
        amplitudes_.push_back(probe.curvature * std::cos(std::numbers::pi / 2 * t * t));
      }
    }
  }

  LossTable make();

 private:
  static constexpr int places = 16;  ///< of a sine, crowded where it is highest: near first slip all is lost there
  struct Loops {
    int steps = 0, points = 0;
    auto operator<=>(const Loops&) const = default;
  };

  const section::Law& law(int points) {
    std::shared_ptr<const section::Law>& law = laws_[points];
    if (!law) {
      Scene scene = ask_.scene;
      scene.section.points = points;
      law = build::build_law(scene, section::Dimension::planar);
    }
    return *law;
  }
  /// [J/m] of each probe.
  std::vector<double> mean(const std::vector<double>& losses) const {
    std::vector<double> means(ask_.probes.size());
    for (std::size_t i = 0; i < losses.size(); ++i) {
      const double t = (static_cast<double>(i % places) + 0.5) / places;
      means[i / places] += 2 * t * losses[i] / places;
    }
    return means;
  }
  const std::vector<double>& by_loops(const Loops& loops) {
    const auto [at, is_new] = means_.try_emplace(loops);
    if (is_new) {
      at->second = mean(loss_per_cycle(law(loops.points), ask_.state, amplitudes_,
                                       {.steps = loops.steps, .stop = ask_.stop}, effort_));
    }
    return at->second;
  }
  /// [-] the largest of the probes.
  double apart(const std::vector<double>& a, const std::vector<double>& b) const {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double size = std::max(a[i], ask_.probes[i].least_loss);
      if (size > 0) largest = std::max(largest, std::abs(a[i] - b[i]) / size);
    }
    return largest;
  }
  void judge_loops();
  bool refine_loops();
  SectionalLoss table();

  const TableAsk& ask_;
  Free free_;
  bool slips_;
  Setting first_, setting_;
  PointError error_;
  std::vector<double> amplitudes_;
  std::map<int, std::shared_ptr<const section::Law>> laws_;
  std::map<Loops, std::vector<double>> means_;
  section::Effort effort_;
};

void Tuning::judge_loops() {
  constexpr analysis::Order in_steps{.least = 1, .highest = 2, .expected = 2};
  constexpr int fewest_steps = 8;  // that differences are taken with
  const int s = setting_.steps, p = setting_.points;
  const Loops best = {.steps = s, .points = p}, half = {.steps = std::max(2, s / 4 * 2), .points = p};
  const bool quartered = s / 4 >= fewest_steps;
  const Loops quick = quartered ? Loops{.steps = s / 8 * 2, .points = p} : half;
  error_.steps =
      analysis::richardson(apart(by_loops(best), by_loops(half)),
                           quartered ? std::optional(apart(by_loops(half), by_loops(quick))) : std::nullopt, in_steps);
  if (!slips_) return;
  const Loops other = {.steps = half.steps, .points = finer_points(p).value_or(p / 2)};
  error_.points = by_points_alone * apart(by_loops(half), by_loops(other));
}

/// Refines what gives the larger part, of what the case has left open. False where nothing is left that would help.
bool Tuning::refine_loops() {
  const std::optional<int> finer = finer_points(setting_.points);
  const double steps = free_.steps && setting_.steps < most_finer * first_.steps ? *error_.steps : 0;
  const double points = free_.points && finer ? error_.points.value_or(0) : 0;
  const double allowed = (1 - share_of_table) * ask_.target;
  const double kept = (steps > 0 ? 0 : *error_.steps) + (points > 0 ? 0 : error_.points.value_or(0));
  if (std::max(steps, points) == 0 || kept > allowed) return false;
  if (steps < points) {
    setting_.points = *finer;
    return true;
  }
  // As much finer as to make up for all that is too much.
  const double wanted = (*error_.steps + error_.points.value_or(0) - allowed) / steps;
  const double factor = std::clamp(1 / std::sqrt(std::max(1 - 1.1 * wanted, 0.01)), 1.2, 4.0);
  setting_.steps = std::min(eightfold(setting_.steps * factor), most_finer * first_.steps);
  return true;
}

SectionalLoss Tuning::table() {
  SectionalLoss loss(law(setting_.points), ask_.state, ask_.range,
                     {.steps = setting_.steps,
                      .knots_per_decade = setting_.knots,
                      .tolerance = setting_.tolerance,
                      .stop = ask_.stop});
  effort_ += loss.effort();
  std::vector<double> losses;
  for (const double amplitude : amplitudes_) losses.push_back(loss.at(amplitude));
  const std::vector<double>& exact = by_loops({.steps = setting_.steps, .points = setting_.points});
  error_.table = by_table_alone * apart(exact, mean(losses));
  error_.relative = *error_.steps + *error_.table + error_.points.value_or(0);
  return loss;
}

LossTable Tuning::make() {
  for (int round = 1;; ++round) {
    judge_loops();
    const double sum = *error_.steps + error_.points.value_or(0);
    if (sum <= (1 - share_of_table) * ask_.target || round == most_rounds || !refine_loops()) break;
  }
  SectionalLoss loss = table();
  for (int round = 1; round < most_tables && !error_.is_below(ask_.target); ++round) {
    if (!free_.knots && !free_.tolerance) break;
    if (*error_.relative - *error_.table > ask_.target) break;  // a finer one would not help
    if (free_.knots) setting_.knots = setting_.knots * 3 / 2;
    if (free_.tolerance) setting_.tolerance /= 4;
    loss = table();
  }
  LossTable table = loss.table();
  error_.section_evaluations = effort_.evaluations - table.evaluations;
  table.evaluations = effort_.evaluations;
  table.sweeps = effort_.sweeps;
  table.error = error_;
  table.chosen = choice_of(setting_, free_);
  return table;
}

}  // namespace

LossTable table_to_target(const TableAsk& ask) {
  return Tuning(ask).make();
}

PointChoice first_choice_of_table(const Scene& scene, double target) {
  return choice_of(first_setting(scene, target), Free(scene));
}

}  // namespace strandyn::self_damping
