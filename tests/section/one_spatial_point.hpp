#pragma once
/// \file One section point of a spatial law, for tests that walk along a path by hand.

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "strandyn/section/law.hpp"

namespace strandyn::test {

struct SpatialStrain {
  double eps = 0;   ///< [-]
  double chi1 = 0;  ///< [rad/m]
  double chi2 = 0;  ///< [1/m]
  double chi3 = 0;  ///< [1/m]
};

class OneSpatialPoint {
 public:
  struct Answer {
    double N = 0;
    double M1 = 0;
    double M2 = 0;
    double M3 = 0;
    std::array<std::array<double, 4>, 4> tangent{};
    bool swept = false;
  };
  struct Loss {
    double stored = 0;
    double dissipated = 0;
    double quadrature_error = 0;
    bool swept = false;
  };

  OneSpatialPoint(const section::Law& law, SpatialStrain start) : law_(law), history_(law.start(field(start))) {}

  section::WireState wires() const { return law_.wires(history_, {}, 0); }

  Answer respond(SpatialStrain to) const {
    using section::Component;
    section::Field stresses(section::Dimension::spatial, 1);
    section::TangentField tangents(section::Dimension::spatial, 1);
    const auto effort = law_.respond(history_, field(to), stresses, &tangents);
    Answer answer{.N = stresses[Component::axial][0],
                  .M1 = stresses[Component::torsion][0],
                  .M2 = stresses[Component::bending2][0],
                  .M3 = stresses[Component::bending3][0],
                  .tangent = {},
                  .swept = effort.sweeps == 1};
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) answer.tangent[r][c] = tangents(Component{r}, Component{c})[0];
    }
    return answer;
  }

  Loss commit(SpatialStrain to) {
    section::StepEnergy energy(1);
    const auto effort = law_.commit(history_, field(to), energy);
    return {.stored = energy.stored[0],
            .dissipated = energy.dissipated[0],
            .quadrature_error = energy.quadrature_error[0],
            .swept = effort.sweeps == 1};
  }

 private:
  static section::Field field(SpatialStrain strain) {
    section::Field f(section::Dimension::spatial, 1);
    f[section::Component::axial][0] = strain.eps;
    f[section::Component::torsion][0] = strain.chi1;
    f[section::Component::bending2][0] = strain.chi2;
    f[section::Component::bending3][0] = strain.chi3;
    return f;
  }

  const section::Law& law_;
  section::History history_;
};

/// From 1e-12 to 1e2 1/m and back, slack or pulled, twisted either way: finite numbers and no gain of energy.
inline void check_finite_anywhere(const section::Law& law) {
  for (double eps : {-1e-2, 0.0, 1e-3}) {
    for (double chi1 : {-1.0, 0.0, 1.0}) {
      OneSpatialPoint point(law, {.eps = eps, .chi1 = chi1});
      for (double chi : {1e-12, 1e-4, 0.05, 1e2, -0.05, 0.0}) {
        const SpatialStrain to{.eps = eps, .chi1 = chi1, .chi2 = 0.6 * chi, .chi3 = -0.8 * chi};
        const auto got = point.respond(to);
        const auto loss = point.commit(to);
        CHECK(std::isfinite(got.M2 + got.M3 + loss.stored + loss.quadrature_error));
        for (const auto& row : got.tangent) {
          for (double entry : row) CHECK(std::isfinite(entry));
        }
        CHECK(loss.dissipated >= 0);
        CHECK(std::isfinite(loss.dissipated));
      }
    }
  }
}

}  // namespace strandyn::test
