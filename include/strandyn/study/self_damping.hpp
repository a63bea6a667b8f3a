#pragma once
/// \file The points of a self-damping study, and the roads that lead to one.
///
/// A point is a frequency, an antinode amplitude and a tension; a road computes its self-damping. Roads are functions:
/// pure, called from several threads at once, one point per call. To add a road: a word in casefile/choices.hpp, a
/// function that makes it, a line in `make_road`.

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/build/span.hpp"
#include "strandyn/section/law.hpp"
#include "strandyn/study/sectional_loss.hpp"

namespace strandyn::study {

struct Point {
  casefile::DampingRoad road = casefile::DampingRoad::quadrature;
  double frequency = 0;           ///< [Hz]
  double antinode_amplitude = 0;  ///< [m] half of peak to peak
  double tension = 0;             ///< [N]
  std::optional<int> mode{};      ///< where the case named the frequency by a mode of the span, from 1
};

struct PointResult {
  double self_damping = 0;              ///< [W/m] of the span, by its length
  std::optional<double> free_span{};    ///< [W/m] without the end loops; nothing where there is no free span
  nlohmann::ordered_json details = {};  ///< more keys of the point in summary.json, numbers of the road's own
  section::Effort effort{};             ///< what it took beyond what the points of a road share; part of the row
  std::string failure{};                ///< why there are no numbers; empty otherwise
  bool stopped = false;                 ///< ended by `stop`: it will be computed again
};

/// A ComputationError thrown is a failure of the point, not of the study.
using Road = std::function<PointResult(const Point&)>;

/// Takes the road to the point. The row of summary.json: the numbers, or `failed` with the reason; nothing where the
/// road was stopped.
std::optional<nlohmann::ordered_json> compute_row(const casefile::Scene& scene, const Road& road, const Point& point);

/// All points of the study: the grid (tensions, in them frequencies, in them amplitudes), then [[analysis.at]].
std::vector<Point> self_damping_points(const casefile::Scene& scene);

/// The road "foti-2018": the closed form, with the numbers of [analysis.foti_2018] or of the strand.
Road simplified_road(const casefile::Scene& scene);

/// The road "quadrature", with its tables of the sectional loss, one per tension. They are made for the range of all
/// points of the study and of its energy balances, so that no number depends on what is left to do.
class Quadrature {
 public:
  Quadrature(const casefile::Scene& scene, const std::vector<Point>& points);

  struct Table {
    double tension = 0;  ///< [N]
    SectionalLoss loss;
  };
  PointResult operator()(const Point& point) const;
  const std::vector<Table>& tables() const { return tables_; }
  const SectionalLoss& at_tension(double tension) const;
  /// [1/m] amplitude of the curvature of the free span.
  double free_span_curvature(const Point& point) const;
  /// [J/m] per cycle: what a sine of this curvature loses at any tension, without a table, for ratios: by the rule of
  /// 24 places.
  double loss_at(double tension, double curvature) const;

 private:
  const casefile::Scene& scene_;
  build::SectionNumbers numbers_;
  double mass_ = 0;  ///< [kg/m]
  std::vector<Table> tables_;
};

/// What a road may look at when it is made. The scene must outlive it.
struct RoadContext {
  const casefile::Scene& scene;
  std::shared_ptr<const Quadrature> quadrature;       ///< where the study asks for it
  std::function<bool()> stop;                         ///< a road of many seconds asks it now and then; from any thread
  std::function<void(const std::string&)> tell = {};  ///< and tells how far it is
};

/// The road "transient": a test bench in time. Throws InputError for what no bench can do.
Road transient_road(const RoadContext& context);

Road make_road(casefile::DampingRoad road, const RoadContext& context);

}  // namespace strandyn::study
