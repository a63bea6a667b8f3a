#include <fmt/format.h>

#include <mutex>

#include "parts.hpp"
#include "self_damping_parts.hpp"
#include "self_damping_periodic.hpp"
#include "side_by_side.hpp"
#include "test_bench.hpp"

namespace strandyn::study {

using casefile::DampingRoad;
using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

/// The points that are left to do, on all cores; every one that ends is in the log at once.
class March {
 public:
  March(const Scene& scene, const Hooks& hooks, const std::vector<Point>& points, PointLog& log)
      : scene_(scene), hooks_(hooks), points_(points), log_(log) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!log.rows().contains(i)) left_.push_back(i);
    }
  }

  void run(const std::shared_ptr<const Quadrature>& quadrature) {
    const RoadContext context = {.scene = scene_,
                                 .quadrature = quadrature,
                                 .stop = [this] { return stop(); },
                                 .tell =
                                     [this](const std::string& words) {
                                       const std::lock_guard lock(mutex_);
                                       tell(", " + words);
                                     }};
    for (const Point& point : points_) {
      if (!roads_.contains(point.road)) roads_[point.road] = make_road(point.road, context);
    }
    tell();
    side_by_side(left_.size(), [this](std::size_t i) { compute(left_[i]); });
  }

 private:
  bool stop() {
    const std::lock_guard lock(mutex_);
    return hooks_.stop && hooks_.stop();
  }

  void compute(std::size_t i) {
    if (stop()) return;
    const std::optional<json> row = compute_row(scene_, roads_.at(points_[i].road), points_[i]);
    if (!row) return;
    const std::lock_guard lock(mutex_);
    log_.add(i, *row);
    tell();
  }

  void tell(const std::string& more = {}) const {
    if (!hooks_.progress) return;
    const std::size_t done = log_.rows().size();
    hooks_.progress(static_cast<double>(done) / static_cast<double>(points_.size()),
                    fmt::format("point {} of {}{}", done, points_.size(), more));
  }

  const Scene& scene_;
  const Hooks& hooks_;
  const std::vector<Point>& points_;
  PointLog& log_;
  std::vector<std::size_t> left_;
  std::map<DampingRoad, Road> roads_;
  std::mutex mutex_;
};

/// points_<road>.csv, one line per point that has numbers.
void add_point_tables(const json& rows, CaseResult& result) {
  for (const auto& [road, name] : casefile::choices<DampingRoad>) {
    results::Table table({"frequency_Hz", "antinode_amplitude_m", "tension_N", "self_damping_W_per_m",
                          "self_damping_free_span_W_per_m"});
    for (const json& row : rows) {
      if (row["road"] != name || row.contains("failed")) continue;
      const double whole = row["self_damping_W_per_m"];
      table.append(std::array<double, 5>{row["frequency_Hz"], row["antinode_amplitude_m"], row["tension_N"], whole,
                                         row.value("self_damping_free_span_W_per_m", whole)});
    }
    if (table.rows() > 0) result.tables.push_back({fmt::format("points_{}.csv", name), std::move(table)});
  }
}

void add_loss_table(const Quadrature& quadrature, CaseResult& result) {
  results::Table table({"tension_N", "curvature_per_m", "loss_J_per_m"});
  section::Effort effort;
  for (const Quadrature::Table& entry : quadrature.tables()) {
    effort += entry.loss.effort();
    for (std::size_t i = 0; i < entry.loss.amplitudes().size(); ++i) {
      table.append(std::array{entry.tension, entry.loss.amplitudes()[i], entry.loss.losses()[i]});
    }
  }
  result.tables.push_back({"sectional_loss.csv", std::move(table)});
  json& cost = result.summary["cost"];
  cost["section_evaluations"] = cost["section_evaluations"].get<std::uint64_t>() + effort.evaluations;
  cost["section_sweeps"] = cost["section_sweeps"].get<std::uint64_t>() + effort.sweeps;
}

}  // namespace

void run_self_damping(const Scene& scene, const Hooks& hooks, CaseResult& result) {
  const std::vector<Point> points = self_damping_points(scene);
  PointLog log(hooks.folder, study_identity(scene));
  std::shared_ptr<const Quadrature> quadrature;
  if (needs_quadrature(scene.analysis.self_damping)) quadrature = std::make_shared<const Quadrature>(scene, points);
  March march(scene, hooks, points, log);
  march.run(quadrature);

  json& s = result.summary;
  s["points"] = json::array();
  std::size_t failed = 0;
  section::Effort effort;  // from the rows: a study that was interrupted counts like one that was not
  for (const auto& [number, row] : log.rows()) {
    s["points"].push_back(row);
    failed += row.contains("failed") ? 1 : 0;
    effort += {.evaluations = row.value("section_evaluations", std::uint64_t{0}),
               .sweeps = row.value("section_sweeps", std::uint64_t{0})};
  }
  s["cost"]["section_evaluations"] = effort.evaluations;
  s["cost"]["section_sweeps"] = effort.sweeps;
  add_point_tables(s["points"], result);
  const std::optional<analysis::PowerLaw> law = add_fits(scene, s);
  if (quadrature) {
    add_onsets(scene, *quadrature, points, s);
    add_road_comparison(*quadrature, s);
    add_loss_table(*quadrature, result);
  }
  if (log.rows().size() < points.size()) {
    result.exit_code = ExitCode::interrupted;
    result.message =
        fmt::format("stopped after {} of {} points; the same run goes on from there", log.rows().size(), points.size());
    return;
  }
  log.finish();
  add_energy_balances({.scene = scene, .points = points, .quadrature = quadrature.get(), .fit = law}, result);
  if (failed == 0) return;
  result.exit_code = ExitCode::not_converged;
  result.message = fmt::format("{} of {} points failed; each says why in its row", failed, points.size());
}

void describe_self_damping(const Scene& scene, json& out) {
  build::check_buildable(scene);
  const std::vector<Point> points = self_damping_points(scene);
  std::map<std::string, std::size_t> roads;
  for (const Point& point : points) ++roads[std::string(casefile::name_of(point.road))];
  out["study"] = {{"points", points.size()},
                  {"roads", roads},
                  {"tensions_N", distinct_tensions(points)},
                  {"mode_shape", casefile::name_of(scene.analysis.self_damping.mode_shape)}};
  double periodic = 0, transient = 0;
  for (const Point& point : points) {
    if (point.road == DampingRoad::periodic) periodic += expected_evaluations(scene, point);
    if (point.road == DampingRoad::transient) transient += expected_bench_evaluations(scene, point);
  }
  if (periodic > 0) out["study"]["expected_cost"]["periodic_section_evaluations"] = periodic;
  if (transient > 0) out["study"]["expected_cost"]["transient_section_evaluations"] = transient;
}

}  // namespace strandyn::study
