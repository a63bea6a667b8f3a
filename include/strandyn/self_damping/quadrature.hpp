#pragma once
/// \file The method "quadrature": the sectional loss summed over the free span as a sine, or over a clamped mode; no
/// time is integrated. The metal of the wires and still air come in closed form beside it: pi f E'' chi^2 and the power
/// of a sine of velocity, the mean over the same lengths. Its tables of the sectional loss, one per tension, are made
/// for the range of all points of the study and of its energy balances, so that no number depends on what is left to
/// do, and by which machine: a shard makes those of its own points only, a study that goes on none of those it has
/// kept.

#include "strandyn/build/losses.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/self_damping/method.hpp"
#include "strandyn/self_damping/mode_loss.hpp"
#include "strandyn/self_damping/sectional_loss.hpp"

namespace strandyn::self_damping {

class Quadrature final : public Method {
 public:
  explicit Quadrature(const casefile::Scene& scene);

  using Method::begin;
  void begin(const std::vector<Point>& points, const Beginning& how) override;
  PointResult at(const Point& point, const Watch& watch) const override;
  Expected expected(const std::vector<Point>& points) const override;
  std::optional<PointChoice> first_choice(const Point& point) const override;

  struct Table {
    double tension = 0;  ///< [N]
    SectionalLoss loss;
    section::MaterialLoss material;
    std::optional<PointError> error{};  ///< where the case asks for an accuracy, like the next
    std::optional<PointChoice> chosen{};
  };
  const std::vector<Table>& tables() const { return tables_; }
  const SectionalLoss& at_tension(double tension) const;
  /// The loop of a point where the quadrature goes over a sine.
  Loop loop_at(const Point& point) const;
  /// Whether the wave of a point follows from its frequency; over clamped modes the length of the span gives it.
  bool wave_follows_frequency() const;
  /// [1/m] amplitude of the curvature of the free span.
  double free_span_curvature(const Point& point) const;
  /// [1/m^2] curvature over antinode amplitude while all wires stick.
  double curvature_of_small_amplitude(const Point& point) const;
  /// [J/m] per cycle: what a sine of this curvature loses at any tension, without a table, for ratios: by the rule of
  /// 24 places.
  double loss_at(double tension, double curvature) const;

 private:
  const Table& table_of(double tension) const;
  Loop loop_by(const SectionalLoss& loss, const Point& point) const;
  LossTable loss_table(double tension, const std::vector<Point>& points, const Beginning& how) const;
  LossTable make_table(double tension, const std::vector<Point>& points, const CurvatureRange& range,
                       const Stop& stop) const;
  std::vector<Point> losing(const std::vector<Point>& points, const SectionState& state, section::Effort& effort) const;
  PointResult by_table(const SectionalLoss& loss, const section::MaterialLoss& material, const Point& point) const;

  const casefile::Scene& scene_;
  build::SectionNumbers numbers_;
  double mass_ = 0;  ///< [kg/m]
  std::optional<model::Surroundings> surroundings_;
  std::shared_ptr<const section::Law> law_;
  std::vector<Table> tables_;
};

}  // namespace strandyn::self_damping
