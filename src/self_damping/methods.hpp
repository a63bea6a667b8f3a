#pragma once
/// \file The methods that vibrate a whole span.

#include "strandyn/build/method.hpp"
#include "strandyn/laboratory/test_bench.hpp"
#include "strandyn/self_damping/method.hpp"
#include "strandyn/span/shaken_span.hpp"

namespace strandyn::self_damping {

/// "periodic": the steady state of a shaken span, solved directly at phase resonance.
class PeriodicMethod final : public Method {
 public:
  explicit PeriodicMethod(const casefile::Scene& scene);
  PointResult at(const Point& point, const Watch& watch) const override;
  Expected expected(const std::vector<Point>& points) const override;
  std::optional<PointChoice> first_choice(const Point& point) const override;
  std::optional<Expected> expected_by_trial(const std::vector<Point>& points) const override;

 private:
  PointResult to_target(const Point& point, double target, const Watch& watch) const;
  /// A coarse resonance, of what a point will take.
  struct Trial {
    double rounds = 0;   ///< [-] around each of its loops
    double seconds = 0;  ///< [s] of an evaluation of a section, the equations of the span included
    bool slips = false;
    int loops = 1;
  };
  Trial try_coarse(const Point& point) const;
  /// Of the point as it begins: its sections times its samples; and the coefficients of its harmonics.
  struct Size {
    double loops = 0, coefficients = 0;
  };
  Size size_of(const Point& point) const;

  const casefile::Scene& scene_;
  span::ResponseOptions options_;
};

/// "transient": a test bench in time.
class TransientMethod final : public Method {
 public:
  explicit TransientMethod(const casefile::Scene& scene);
  PointResult at(const Point& point, const Watch& watch) const override;
  Expected expected(const std::vector<Point>& points) const override;

 private:
  const casefile::Scene& scene_;
  build::Integration integration_;
  laboratory::BenchOptions options_;
};

}  // namespace strandyn::self_damping
