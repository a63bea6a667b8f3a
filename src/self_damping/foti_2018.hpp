#pragma once
/// \file The method "foti-2018": the closed form, with the numbers of [analysis.foti_2018] or of the strand. [FM2018]

#include "strandyn/build/section_law.hpp"
#include "strandyn/self_damping/method.hpp"

namespace strandyn::self_damping {

class ClosedForm final : public Method {
 public:
  explicit ClosedForm(const casefile::Scene& scene);
  PointResult at(const Point& point, const Watch& watch) const override;
  Expected expected(const std::vector<Point>&) const override { return {}; }

 private:
  const casefile::Scene& scene_;
  build::SectionNumbers numbers_;
  double mass_ = 0;  ///< [kg/m]
  casefile::SimplifiedLoss given_;
};

}  // namespace strandyn::self_damping
